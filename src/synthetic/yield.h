#pragma once

#include "synthetic/dressed_person.h"

namespace regarment {

/// Presses in what would stick through the cloth between its particles: flesh below the innermost
/// garment, cloth below further ones. `person` is dressed with hardly any of it; what lies deeper
/// than 2 cm stays. Afterwards the middle of the cloth keeps half its thickness from what is below.
void yield_to_cloth(DressedPerson& person);

}  // namespace regarment
