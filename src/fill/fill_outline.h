#pragma once

#include <optional>
#include <vector>

#include "geometry/closest_point.h"

namespace regarment {

/// Surface that closes an outline. Indices below the outline's size are its points, the others
/// count `inner`.
struct Patch {
  std::vector<Vec3> inner;
  std::vector<Triangle> triangles;  // counter-clockwise seen from the side that has it on its left
};

/// Closes an outline of at least three points with the cloth that lies there: a triangulation of
/// the outline, refined to its own point distance, its inner points laid on `cloth`; near the
/// outline they go over to it smoothly. Every edge of the outline gets exactly one triangle, every
/// other edge of the patch that is not on it two. Nothing when the outline cannot be triangulated.
std::optional<Patch> fill_outline(const std::vector<Vec3>& outline, const ClosestPoint& cloth);

}  // namespace regarment
