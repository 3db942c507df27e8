#include "geometry/surface_element.h"

#include <Eigen/Geometry>
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

bool usable(const Vec3& v) {
  return (v.array().abs() <= kLargestCoordinate).all();
}  // false for NaN

bool is_direction(const Vec3& v) { return v.isZero(0) || std::abs(v.squaredNorm() - 1) <= 2e-4; }

int compare_places(const Vec3& a, const Vec3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis]) return a[axis] < b[axis] ? -1 : 1;
  return 0;
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

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
  return (b - a).cross(c - a).norm() > kNoArea * longest;
}

// Which corner of the triangle comes first, second and third by coordinates.
std::array<int, 3> sorted_corners(std::span<const Vec3> positions, const Triangle& triangle) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    return compare_places(positions[triangle[i]], positions[triangle[j]]) < 0;
  });
  return order;
}

}  // namespace

TriangleElements::TriangleElements(std::span<const Vec3> positions,
                                   std::span<const Triangle> triangles,
                                   std::span<const std::uint8_t> masked)
    : places_(positions.begin(), positions.end()) {
  require_count(triangles.size());
  require_size(masked.size(), triangles.size(), "mask entries");
  std::vector<std::uint32_t> kept;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool leave_out = !masked.empty() && masked[t] != 0;
    require_corners(positions, triangles[t], t, leave_out);
    if (!leave_out) kept.push_back(static_cast<std::uint32_t>(t));
  }
  const std::vector<std::uint8_t> border = border_flags(triangles, kept, positions.size());
  items_.reserve(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Triangle& triangle = triangles[kept[i]];
    if (!has_area(positions[triangle[0]], positions[triangle[1]], positions[triangle[2]])) continue;
    const std::array<int, 3> order = sorted_corners(positions, triangle);
    Item item;
    item.index = kept[i];
    for (int k = 0; k < 3; ++k) {
      item.places[k] = triangle[order[k]];
      item.border = static_cast<std::uint8_t>(item.border | (border[i] >> order[k] & 0x09) << k);
    }
    item.turned = (order[1] + 3 - order[0]) % 3 != 1;
    items_.push_back(item);
  }
}

TriangleElements::TriangleElements(const TriangleElements& from,
                                   std::span<const std::uint32_t> order) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> renumbered(from.places_.size(), kUnused);
  items_.reserve(order.size());
  for (const std::uint32_t i : order) {
    items_.push_back(from.items_[i]);
    for (std::uint32_t& place : items_.back().places) {
      std::uint32_t& number = renumbered[place];
      if (number == kUnused) {
        number = static_cast<std::uint32_t>(places_.size());
        places_.push_back(from.places_[place]);
      }
      place = number;
    }
  }
}

Vec3 TriangleElements::normal(std::size_t i) const {
  const auto [a, b, c] = corners(i);
  const Vec3 across = (b - a).cross(c - a).normalized();
  return items_[i].turned ? Vec3(-across) : across;
}

NearestPlace TriangleElements::nearest(std::size_t i, const Vec3& query) const {
  const std::array<Vec3, 3> corner = corners(i);
  const Vec3 ab = corner[1] - corner[0], ac = corner[2] - corner[0], ap = query - corner[0];
  const Vec3 across = ab.cross(ac);
  const double squared = across.squaredNorm();
  const double v = ap.cross(ac).dot(across) / squared;
  const double w = ab.cross(ap).dot(across) / squared;
  const std::array<double, 3> weights{1 - v - w, v, w};
  const bool inside = weights[0] > kOnEdge && v > kOnEdge && w > kOnEdge;
  const double length = ab.squaredNorm() + ac.squaredNorm();
  const bool thin = !(squared > kThin * kThin * length * length);

  NearestPlace best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  if (inside) {
    const Vec3 point = corner[0] + v * ab + w * ac;
    best = {point, (query - point).squaredNorm(), false};
    if (!thin) return best;
  }
  // Outside, the nearest point is on an edge that has the query on its far side.
  const int border = items_[i].border;
  for (int k = 0; k < 3; ++k) {
    if (!thin && weights[k] > kOnEdge) continue;
    const int from = k == 0 ? 1 : 0, to = k == 2 ? 1 : 2;  // the edge facing corner k
    const Vec3 edge = corner[to] - corner[from];
    const double along = (query - corner[from]).dot(edge) / edge.squaredNorm();
    const bool at_end = along <= 0 || along >= 1;
    const int end = along <= 0 ? from : to;
    const Vec3 point = at_end ? corner[end] : Vec3(corner[from] + along * edge);
    const double squared_distance = (query - point).squaredNorm();
    if (squared_distance < best.squared_distance ||
        (squared_distance == best.squared_distance && at_end))
      best = {point, squared_distance, (border >> (at_end ? end : 3 + k) & 1) != 0};
  }
  return best;
}

int TriangleElements::compare(std::size_t i, std::size_t j) const {
  const std::array<Vec3, 3> a = corners(i), b = corners(j);
  for (int k = 0; k < 3; ++k)
    if (const int order = compare_places(a[k], b[k]); order != 0) return order;
  return static_cast<int>(items_[i].turned) - static_cast<int>(items_[j].turned);
}

PointElements::PointElements(std::span<const Vec3> points, std::span<const Vec3> normals,
                             std::span<const std::uint8_t> masked) {
  require_count(points.size());
  require_size(normals.size(), points.size(), "normals");
  require_size(masked.size(), points.size(), "mask entries");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!masked.empty() && masked[i] != 0) continue;
    if (!usable(points[i]))
      throw InvalidInput("closest point: point " + std::to_string(i) + " is not finite");
    if (!normals.empty() && !is_direction(normals[i]))
      throw InvalidInput("closest point: the normal of point " + std::to_string(i) +
                         " is neither of unit length nor zero");
    points_.push_back(points[i]);
    if (!normals.empty()) normals_.push_back(normals[i]);
    indices_.push_back(static_cast<std::uint32_t>(i));
  }
}

PointElements::PointElements(const PointElements& from, std::span<const std::uint32_t> order) {
  for (const std::uint32_t i : order) {
    points_.push_back(from.points_[i]);
    if (!from.normals_.empty()) normals_.push_back(from.normals_[i]);
    indices_.push_back(from.indices_[i]);
  }
}

int PointElements::compare(std::size_t i, std::size_t j) const {
  const int order = compare_places(points_[i], points_[j]);
  return order != 0 ? order : compare_places(normal(i), normal(j));
}

}  // namespace regarment
