#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "render/camera.h"

namespace regarment {

/// The points that a camera may see, in order: leaves out those that lie more than `depth_margin`
/// (m) behind other points all round, in a raster of squares of `reach` pixels and their eight
/// neighbours. Most of a body's far side goes this way at a fraction of the cost of drawing it.
/// `points` are relative to `origin`.
std::vector<std::uint32_t> visible_points(std::span<const Eigen::Vector3f> points,
                                          const Vec3& origin, const Camera& camera, double reach,
                                          double depth_margin);

}  // namespace regarment
