#pragma once

#include "render/geometry_pass.h"

namespace regarment {

/// Averages the normals of neighbouring pixels (about `radius` pixels each way) where the depth
/// runs on without a step of more than `depth_step` (m): the discs of a cloud become one smooth
/// surface, edges stay sharp.
void smooth_normals(GeometryBuffers& buffers, double radius, double depth_step);

}  // namespace regarment
