#include "geometry/border_edges.h"

#include <algorithm>
#include <tuple>

namespace regarment {
namespace {

// An edge as one triangle has it, filed under the lower of its two vertices.
struct EdgeUse {
  std::uint32_t higher = 0;  // its other vertex
  std::uint32_t triangle = 0;
  std::uint8_t facing = 0;  // the corner of the triangle that is not on it

  bool operator<(const EdgeUse& other) const {
    return std::tie(higher, triangle, facing) <
           std::tie(other.higher, other.triangle, other.facing);
  }
};

struct Edges {
  std::vector<EdgeUse> uses;
  std::vector<std::size_t> begin;  // of each vertex' uses; one more than vertices
};

template <class Visit>
void each_edge(std::span<const Triangle> triangles, std::span<const std::uint32_t> kept,
               Visit&& visit) {
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    const Triangle& corner = triangles[kept[t]];
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (std::uint8_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corner[(k + 1) % 3], corner[(k + 2) % 3]);
      visit(low, EdgeUse{high, t, k});
    }
  }
}

Edges file_edges(std::span<const Triangle> triangles, std::span<const std::uint32_t> kept,
                 std::size_t vertices) {
  Edges edges;
  edges.begin.assign(vertices + 1, 0);
  each_edge(triangles, kept, [&](std::uint32_t low, const EdgeUse&) { ++edges.begin[low + 1]; });
  for (std::size_t v = 0; v < vertices; ++v) edges.begin[v + 1] += edges.begin[v];
  edges.uses.resize(edges.begin.back());
  std::vector<std::size_t> next(edges.begin.begin(), edges.begin.end() - 1);
  each_edge(triangles, kept,
            [&](std::uint32_t low, const EdgeUse& use) { edges.uses[next[low]++] = use; });
  for (std::size_t v = 0; v < vertices; ++v)
    std::sort(edges.uses.begin() + edges.begin[v], edges.uses.begin() + edges.begin[v + 1]);
  return edges;
}

}  // namespace

std::vector<std::uint8_t> border_flags(std::span<const Triangle> triangles,
                                       std::span<const std::uint32_t> kept, std::size_t vertices) {
  const Edges edges = file_edges(triangles, kept, vertices);
  std::vector<std::uint8_t> flags(kept.size(), 0);
  std::vector<std::uint8_t> vertex_on_border(vertices, 0);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t i = edges.begin[v]; i < edges.begin[v + 1];) {
      std::size_t end = i + 1;
      while (end < edges.begin[v + 1] && edges.uses[end].higher == edges.uses[i].higher) ++end;
      if (end == i + 1) {
        const EdgeUse& use = edges.uses[i];
        flags[use.triangle] = static_cast<std::uint8_t>(flags[use.triangle] | 8U << use.facing);
        vertex_on_border[v] = vertex_on_border[use.higher] = 1;
      }
      i = end;
    }
  }
  for (std::size_t t = 0; t < kept.size(); ++t) {
    const Triangle& corner = triangles[kept[t]];
    for (int k = 0; k < 3; ++k)
      flags[t] = static_cast<std::uint8_t>(flags[t] | vertex_on_border[corner[k]] << k);
  }
  return flags;
}

}  // namespace regarment
