#include "geometry/surface_element.h"

#include <algorithm>
#include <limits>
#include <string>

#include "base/error.h"
#include "geometry/border_edges.h"

namespace regarment {
namespace {

// Barycentric coordinates nearer to 0 than this are on an edge: a matter of rounding.
constexpr double kOnEdge = 1e-14;
// A triangle whose height is less than this part of its length has barycentric coordinates of
// little worth, so its edges are asked as well.
constexpr double kThin = 1e-4;
// Area by longest edge squared, below which there is no normal.
constexpr double kNoArea = 1e-12;
constexpr double kLargest = 1e150;

bool usable(const Vec3& v) { return (v.array().abs() <= kLargest).all(); }  // false for NaN

bool comes_before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

void require_size(std::size_t size, std::size_t count, const char* what) {
  if (size == 0 || size == count) return;
  throw InvalidInput("closest point: " + std::to_string(size) + " " + what + " for " +
                     std::to_string(count) + " elements; give one for each or none");
}

void require_count(std::size_t count) {
  if (count < std::numeric_limits<std::uint32_t>::max()) return;
  throw InvalidInput("closest point: " + std::to_string(count) +
                     " elements are more than the tree can number; give fewer than 2^32 - 1");
}

[[noreturn]] void refuse_corner(std::size_t triangle, std::uint32_t vertex,
                                const std::string& why) {
  throw InvalidInput("closest point: triangle " + std::to_string(triangle) + " names vertex " +
                     std::to_string(vertex) + why);
}

void require_corners(std::span<const Vec3> positions, const Triangle& triangle, std::size_t t,
                     bool masked) {
  for (const std::uint32_t vertex : triangle) {
    if (vertex >= positions.size())
      refuse_corner(t, vertex, ", but there are " + std::to_string(positions.size()));
    if (!masked && !usable(positions[vertex]))
      refuse_corner(t, vertex, ", whose position is not finite");
  }
}

double longest_edge_squared(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
}

TriangleElement make_triangle(std::span<const Vec3> positions, const Triangle& triangle,
                              std::size_t t, std::uint8_t border) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    return comes_before(positions[triangle[i]], positions[triangle[j]]);
  });
  TriangleElement element;
  for (int k = 0; k < 3; ++k) {
    element.corners[k] = positions[triangle[order[k]]];
    const int here = border >> order[k];
    element.border = static_cast<std::uint8_t>(element.border | (here & 0x09) << k);
  }
  const Vec3& a = positions[triangle[0]];
  element.normal = (positions[triangle[1]] - a).cross(positions[triangle[2]] - a).normalized();
  element.index = static_cast<std::uint32_t>(t);
  return element;
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).norm() > kNoArea * longest_edge_squared(a, b, c);
}

}  // namespace

NearestPlace TriangleElement::nearest(const Vec3& query) const {
  const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0], ap = query - corners[0];
  const Vec3 doubled_area = ab.cross(ac);
  const double squared = doubled_area.squaredNorm();
  const double v = ap.cross(ac).dot(doubled_area) / squared;
  const double w = ab.cross(ap).dot(doubled_area) / squared;
  const std::array<double, 3> weights{1 - v - w, v, w};
  const bool inside = weights[0] > kOnEdge && v > kOnEdge && w > kOnEdge;
  const double length = ab.squaredNorm() + ac.squaredNorm();
  const bool thin = !(squared > kThin * kThin * length * length);

  NearestPlace best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  if (inside || thin) {
    const Vec3 point = corners[0] + std::clamp(v, 0.0, 1.0) * ab +
                       std::clamp(w, 0.0, 1.0 - std::clamp(v, 0.0, 1.0)) * ac;
    best = {point, (query - point).squaredNorm(), false};
    if (!thin) return best;
  }
  // Outside, the nearest point is on an edge that has the query on its far side.
  for (int k = 0; k < 3; ++k) {
    if (!thin && weights[k] > kOnEdge) continue;
    const int i = k == 0 ? 1 : 0, j = k == 2 ? 1 : 2;  // the edge facing corner k, in their order
    const Vec3 edge = corners[j] - corners[i];
    const double along = (query - corners[i]).dot(edge) / edge.squaredNorm();
    const int end = along <= 0 ? i : j;
    const bool at_end = along <= 0 || along >= 1;
    const Vec3 point = at_end ? corners[end] : Vec3(corners[i] + along * edge);
    const double d = (query - point).squaredNorm();
    if (d < best.squared_distance || (d == best.squared_distance && at_end))
      best = {point, d, (border >> (at_end ? end : 3 + k) & 1) != 0};
  }
  return best;
}

std::vector<TriangleElement> triangle_elements(std::span<const Vec3> positions,
                                               std::span<const Triangle> triangles,
                                               std::span<const std::uint8_t> masked) {
  require_count(triangles.size());
  require_size(masked.size(), triangles.size(), "mask entries");
  std::vector<std::uint32_t> kept;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool leave_out = !masked.empty() && masked[t] != 0;
    require_corners(positions, triangles[t], t, leave_out);
    if (!leave_out) kept.push_back(static_cast<std::uint32_t>(t));
  }
  const std::vector<std::uint8_t> border = border_flags(triangles, kept, positions.size());
  std::vector<TriangleElement> elements;
  elements.reserve(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto& [a, b, c] = triangles[kept[i]];
    if (has_area(positions[a], positions[b], positions[c]))
      elements.push_back(make_triangle(positions, triangles[kept[i]], kept[i], border[i]));
  }
  return elements;
}

std::vector<PointElement> point_elements(std::span<const Vec3> points,
                                         std::span<const Vec3> normals,
                                         std::span<const std::uint8_t> masked) {
  require_count(points.size());
  require_size(normals.size(), points.size(), "normals");
  require_size(masked.size(), points.size(), "mask entries");
  std::vector<PointElement> elements;
  elements.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!masked.empty() && masked[i] != 0) continue;
    const Vec3 normal = normals.empty() ? Vec3::Zero() : normals[i];
    if (!usable(points[i]) || !usable(normal))
      throw InvalidInput("closest point: the position or normal of point " + std::to_string(i) +
                         " is not finite");
    elements.push_back({points[i], normal, static_cast<std::uint32_t>(i)});
  }
  return elements;
}

}  // namespace regarment
