#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace regarment::test {

using Facet = std::array<std::array<float, 3>, 3>;

/// A binary STL file; the normals are zero, as many exporters leave them.
inline std::string binary_stl(const std::vector<Facet>& facets) {
  std::string file(80, ' ');
  const auto put = [&](const auto& value) {
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(facets.size()));
  for (const Facet& facet : facets) {
    put(std::array<float, 3>{});
    put(facet);
    put(std::uint16_t{0});
  }
  return file;
}

inline std::string text_stl(const std::vector<Facet>& facets) {
  std::string file = "solid thing\n";
  for (const Facet& facet : facets) {
    file += " facet normal 0 0 0\n  outer loop\n";
    for (const auto& corner : facet) {
      file += "   vertex";
      for (const float c : corner) file += " " + std::to_string(c);
      file += "\n";
    }
    file += "  endloop\n endfacet\n";
  }
  return file + "endsolid thing\n";
}

}  // namespace regarment::test
