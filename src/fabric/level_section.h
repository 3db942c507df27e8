#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// The length of the convex outline round points, seen along the direction in which they spread
/// least: what a tape pulled tight round a section of cloth reads. 0 for fewer than three points
/// and for points on a line. m, like the points; they need no order.
double tape_length(const std::vector<Vec3>& points);

}  // namespace regarment
