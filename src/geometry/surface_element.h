#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Where an element is nearest to a query.
struct NearestPlace {
  Vec3 point = Vec3::Zero();
  double squared_distance = 0.0;
  bool on_border = false;  // on an edge that only one triangle has, ends included
};

/// A triangle of positive area. Its corners stand in the order of their coordinates, not of the
/// mesh, so that neighbours reckon a shared edge by the same steps and agree to the last bit.
struct TriangleElement {
  std::array<Vec3, 3> corners;  // sorted by x, then y, then z
  Vec3 normal;                  // unit, by the order of the corners in the mesh
  std::uint32_t index = 0;      // in the mesh
  std::uint8_t border = 0;  // bit k: corner k is on the border; bit 3 + k: the edge facing it is

  NearestPlace nearest(const Vec3& query) const;
  Vec3 low() const { return corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]); }
  Vec3 high() const { return corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]); }
};

/// A point of a cloud.
struct PointElement {
  Vec3 position;
  Vec3 normal;  // as given; zero without
  std::uint32_t index = 0;

  NearestPlace nearest(const Vec3& query) const {
    return {position, (query - position).squaredNorm(), false};
  }
  const Vec3& low() const { return position; }
  const Vec3& high() const { return position; }
};

/// The triangles that are not masked and have an area: more than a millionth of a millionth of the
/// square of their longest edge, below which a normal is made of rounding alone. An edge is on the
/// border when just one triangle that is not masked names its two vertices; one without area
/// counts, since the surface is closed there. Throws InvalidInput when a used position is not
/// finite or too large to be squared (above 1e150), an index is out of range or `masked` has
/// neither no entry nor one per triangle.
std::vector<TriangleElement> triangle_elements(std::span<const Vec3> positions,
                                               std::span<const Triangle> triangles,
                                               std::span<const std::uint8_t> masked);

/// The points that are not masked. Throws InvalidInput when one of them or its normal is not
/// finite or too large to be squared, or `normals` or `masked` has neither no entry nor one per
/// point.
std::vector<PointElement> point_elements(std::span<const Vec3> points,
                                         std::span<const Vec3> normals,
                                         std::span<const std::uint8_t> masked);

}  // namespace regarment
