#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// How far every node of a regular grid lies from a surface, m, > 0 outside.
struct DistanceField {
  Vec3 origin = Vec3::Zero();  // of node (0, 0, 0), body frame, m
  double cell = 0.0;           // m between neighbouring nodes
  std::array<int, 3> size{};   // nodes along x, y, z
  std::vector<float> value;    // x runs fastest

  std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * size[1] + y) * size[0] + x;
  }
  std::size_t nodes() const { return std::size_t(size[0]) * size[1] * size[2]; }
};

/// The field of the surface that points with outward normals lie on. Near points, two cells
/// along their normals, it is their mean distance along the normals [Hoppe et al. 1992; Curless and
/// Levoy 1996]; elsewhere it goes on harmonically, as the indicator function of Poisson
/// reconstruction does [Kazhdan et al. 2006], which closes what no camera saw: holes, and the
/// opening between a hem and the legs. Positive on the border of the grid, six cells around the
/// points. `cell` (m) is made larger where the grid would have more than 2^24 nodes. Solved on
/// coarser grids first, at the finest one only near the surface. Throws InvalidInput without
/// points, or when one is not finite.
DistanceField distance_field(std::span<const Vec3> points, std::span<const Vec3> normals,
                             double cell);

}  // namespace regarment
