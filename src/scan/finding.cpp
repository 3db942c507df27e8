#include "scan/finding.h"

#include <array>
#include <cstdio>

#include "base/error.h"

namespace regarment {
namespace {

constexpr std::array<std::string_view, 3> kSeverities = {"note", "advice", "problem"};

}  // namespace

std::string_view severity_name(Severity severity) {
  return kSeverities[static_cast<std::size_t>(severity)];
}

Severity severity_named(std::string_view name) {
  for (std::size_t i = 0; i < kSeverities.size(); ++i) {
    if (kSeverities[i] == name) return static_cast<Severity>(i);
  }
  throw InvalidInput("\"" + std::string(name) + "\" is no severity of a finding");
}

std::string counted(std::size_t count, const std::string& thing, const std::string& things) {
  return std::to_string(count) + " " + (count == 1 ? thing : things);
}

std::string percent(double share) {
  if (share < 0.001) return "less than 0.1 %";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), share < 0.1 ? "%.1f %%" : "%.0f %%", 100 * share);
  return text.data();
}

}  // namespace regarment
