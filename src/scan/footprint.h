#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// The convex hull of points, counter-clockwise, corners only. Fewer than 3 points give themselves.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// How many of `points` lie outside of the hulls of all connected groups of `standing`, and not
/// within `reach` of their points. Points nearer than `reach` are connected.
std::size_t outside_of_hulls(std::span<const Vec2> points, std::span<const Vec2> standing,
                             double reach);

}  // namespace regarment
