#pragma once

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

// Reads SVG back, for tests of what is drawn. Knows the commands m, h and v, as relative as the
// standard has them, and nothing of how they are written.

namespace regarment {

using Points = std::vector<std::pair<double, double>>;

/// The `d` of each path of class `kind`, in order.
inline std::vector<std::string> paths_of(const std::string& svg, const std::string& kind) {
  const std::string begin = "<path class=\"" + kind + "\" d=\"";
  std::vector<std::string> out;
  for (auto at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
    const auto from = at + begin.size();
    out.push_back(svg.substr(from, svg.find('"', from) - from));
  }
  return out;
}

/// Where the pen comes to, one point per command.
inline Points points_of(const std::string& d) {
  Points out;
  double x = 0.0, y = 0.0;
  const char* c = d.c_str();
  const auto number = [&c] {
    char* end = nullptr;
    const double value = std::strtod(c, &end);
    c = end;
    return value;
  };
  while (*c != '\0') {
    const char command = *c++;
    if (command == 'm' || command == 'h') x += number();
    if (command == 'm' || command == 'v') y += number();
    out.emplace_back(x, y);
  }
  return out;
}

}  // namespace regarment
