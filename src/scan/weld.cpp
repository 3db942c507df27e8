#include "scan/weld.h"

#include <bit>

namespace regarment {
namespace {

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  for (int axis = 0; axis < 3; ++axis) {
    h ^= std::bit_cast<std::uint64_t>(p[axis] + 0.0);  // + 0.0 turns -0 into 0
    h *= 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

}  // namespace

Welded weld(std::span<const Vec3> vertices) {
  Welded welded;
  welded.of_vertex.assign(vertices.size(), Welded::kNone);
  welded.positions.reserve(vertices.size());
  std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 2), Welded::kNone);
  const std::size_t mask = table.size() - 1;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Vec3& p = vertices[v];
    if (!p.allFinite()) continue;
    std::size_t slot = hash(p) & mask;
    while (table[slot] != Welded::kNone && welded.positions[table[slot]] != p) {
      slot = (slot + 1) & mask;
    }
    if (table[slot] == Welded::kNone) {
      table[slot] = static_cast<std::uint32_t>(welded.positions.size());
      welded.positions.push_back(p);
    }
    welded.of_vertex[v] = table[slot];
  }
  return welded;
}

std::vector<Triangle> weld_triangles(std::span<const Triangle> triangles, const Welded& welded,
                                     std::vector<std::uint32_t>* source) {
  std::vector<Triangle> kept;
  kept.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [i, j, k] = triangles[t];
    const Triangle corners = {welded.of_vertex[i], welded.of_vertex[j], welded.of_vertex[k]};
    const auto [a, b, c] = corners;
    if (a == b || b == c || c == a) continue;
    if (a == Welded::kNone || b == Welded::kNone || c == Welded::kNone) continue;
    kept.push_back(corners);
    if (source) source->push_back(static_cast<std::uint32_t>(t));
  }
  return kept;
}

}  // namespace regarment
