#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "geometry/mesh.h"

namespace regarment::test {

/// A square sheet of `n` x `n` squares of side `step` in the plane z = 0, facing +z; squares for
/// which `hole(i, j)` holds are missing. Vertex (i, j) has the index j (n + 1) + i.
inline Mesh sheet(int n, double step, const std::function<bool(int, int)>& hole = {}) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.positions.emplace_back(i * step, j * step, 0.0);
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (hole && hole(i, j)) continue;
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// How many triangles each undirected edge has.
inline std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_counts(
    const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      ++count[{std::min(a, b), std::max(a, b)}];
    }
  return count;
}

/// How often each directed edge occurs: more than once where neighbours turn differently.
inline std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_counts(
    const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  return count;
}

}  // namespace regarment::test
