#pragma once

#include <span>

#include "geometry/mesh.h"

namespace regarment {

/// A vertical plane that maps a body onto itself, left to right: x n_x + z n_y = offset.
struct MirrorPlane {
  Vec2 normal = Vec2::UnitX();  // unit, horizontal (x, z); either way round
  double offset = 0.0;          // body heights
  double mismatch =
      0.0;  // mean distance of mirrored points to the body, cut off at 0.04 body heights
};

/// Finds it by mirroring the body and moving the plane until nearest points agree, from several
/// starts; then with the parts near the plane alone, since arms may be held unlike. `upright` are
/// points in body heights, +y up, floor at 0. Fewer than 20 points give the default plane with the
/// worst mismatch.
MirrorPlane find_mirror_plane(std::span<const Vec3> upright);

}  // namespace regarment
