#pragma once

#include "synthetic/body_shape.h"
#include "synthetic/case_dice.h"
#include "synthetic/case_outfit.h"

namespace regarment {

/// Draws somebody to wear an outfit: a mixture of two or three bodies of the library, lighter or
/// heavier, standing more or less straight. A fifth hold their arms low; hands keep clear of the
/// hips, further under a skirt.
BodyShape sample_body(Outfit outfit, CaseDice& dice);

}  // namespace regarment
