#pragma once

#include <vector>

#include "synthetic/body_shape.h"
#include "synthetic/case_dice.h"
#include "synthetic/case_outfit.h"

namespace regarment {

/// Draws somebody to wear an outfit: a mixture of two or three bodies of the library, lighter or
/// heavier, standing more or less straight. A fifth hold their arms low; hands keep clear of the
/// hips, further under a skirt.
BodyShape sample_body(Outfit outfit, CaseDice& dice);

/// The body as it moves while it is dressed, see dress_person: from standing upright with the arms
/// stretched sideways to the shape's own pose, the arms in steps of at most 0.15 rad. Only the last
/// pose when the arms are out of the way of what is put on: of a skirt, unless they hang low.
std::vector<Mesh> dressing_poses(Outfit outfit, const BodyShape& shape);

}  // namespace regarment
