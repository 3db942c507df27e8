#pragma once

#include <Eigen/Core>

#include "render/camera.h"

namespace regarment {

/// OpenGL's clip coordinates from body points given relative to `origin`. Rows run downwards:
/// window row 0 is the top row of the picture, so that buffers are read in picture order. |depth|
/// up to `depth_range` is inside the clip volume.
Eigen::Matrix4f clip_from_body(const Camera& camera, const Vec3& origin);

}  // namespace regarment
