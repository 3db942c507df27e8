#pragma once

#include "render/geometry_pass.h"

namespace regarment {

/// Closes small holes between the discs of a cloud: a pixel that shows nothing takes over its
/// nearest neighbour along its row or column, when it has neighbours within `reach` pixels on all
/// four sides and both pairs lie at the same depth to within `depth_step` (m). Outlines stay as
/// they are.
void fill_holes(GeometryBuffers& buffers, int reach, double depth_step);

}  // namespace regarment
