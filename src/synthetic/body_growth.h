#pragma once

#include <vector>

#include "synthetic/body_rig.h"
#include "synthetic/body_shape.h"

namespace regarment {

/// Makes belly, chest, hips, thighs, arms and shoulders of a body in the library's pose what the
/// shape says. `frame` is the body's own, before it grew. The trunk grows away from the body's
/// middle plane and axis by a smooth field, so that legs and arms keep clear of what grows.
void grow_body(const BodyShape& shape, const BodyRig& rig, const BodyJoints& frame,
               std::vector<Vec3>& positions);

}  // namespace regarment
