#pragma once

#include <vector>

#include "synthetic/body_rig.h"
#include "synthetic/body_shape.h"

namespace regarment {

/// Moves arms, legs and spine of a body from the library's pose to the shape's. `frame` is that of
/// the body before it grew. Each joint turns its surroundings by an angle that rises smoothly along
/// the limb, so that nothing creases; the floor is not looked after.
void pose_body(const BodyShape& shape, const BodyRig& rig, const BodyJoints& frame,
               std::vector<Vec3>& positions);

}  // namespace regarment
