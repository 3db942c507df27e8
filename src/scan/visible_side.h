#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Looks at a body from all round (not from straight below, where a skirt is open) and says for
/// each point from which side of its normal it is seen: > 0 the side the normal points to, < 0 the
/// other, 0 not seen; larger is clearer. Points are hidden by `occluders`, a sample of the same
/// surface at most about `pixel` apart. Frame: +y up. `normals` are one per point, unit.
std::vector<float> visible_side(std::span<const Vec3> points, std::span<const Vec3> normals,
                                std::span<const Vec3> occluders, double pixel);

}  // namespace regarment
