#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "bench/closest_point_rivals.h"

namespace regarment {
namespace {

struct Side {
  double squared_length = 0;
  std::uint64_t ends = 0;

  // Longest first; the ends tell equal ones apart, so that the order is one.
  bool operator<(const Side& other) const {
    if (squared_length != other.squared_length) return squared_length > other.squared_length;
    return ends < other.ends;
  }
};

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32U | std::max(a, b);
}

/// Every side once, in the triangles' order.
std::vector<Side> sides_of(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sides.push_back({(mesh.positions[a] - mesh.positions[b]).squaredNorm(), key_of(a, b)});
    }
  const auto same = [](const Side& a, const Side& b) { return a.ends == b.ends; };
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.ends < b.ends; });
  sides.erase(std::unique(sides.begin(), sides.end(), same), sides.end());
  return sides;
}

using Middles = std::unordered_map<std::uint64_t, std::uint32_t>;  // new vertices, by their side

/// New vertices in the middle of the `count` longest sides.
Middles split_longest(Mesh& mesh, std::size_t count) {
  std::vector<Side> sides = sides_of(mesh);
  count = std::min(count, sides.size());
  std::partial_sort(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(count), sides.end());
  Middles middles;
  middles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::uint32_t>(sides[i].ends >> 32U),
               b = static_cast<std::uint32_t>(sides[i].ends);
    middles.emplace(sides[i].ends, static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
    if (!mesh.normals.empty())
      mesh.normals.push_back((mesh.normals[a] + mesh.normals[b]).normalized());
  }
  return middles;
}

/// Cuts off a corner at each split side in turn; what is left has one split side less.
void cut(Triangle t, const Middles& middles, std::vector<Triangle>& out) {
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const auto middle = middles.find(key_of(a, b));
    if (middle == middles.end()) continue;
    cut({a, middle->second, c}, middles, out);
    cut({middle->second, b, c}, middles, out);
    return;
  }
  out.push_back(t);
}

}  // namespace

void subdivide(Mesh& mesh, std::size_t least) {
  while (!mesh.triangles.empty() && mesh.triangles.size() < least) {
    const std::size_t missing = least - mesh.triangles.size();
    // A side between two triangles makes two more of them.
    const Middles middles = split_longest(mesh, (missing + 1) / 2);
    std::vector<Triangle> triangles;
    triangles.reserve(least + 1);
    for (const Triangle& t : mesh.triangles) cut(t, middles, triangles);
    mesh.triangles = std::move(triangles);
  }
}

}  // namespace regarment
