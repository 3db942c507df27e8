#pragma once

#include "synthetic/case_dice.h"
#include "synthetic/case_recipe.h"

namespace regarment {

/// Draws how a case is scanned: the scanner and its faults, density, colours, unit and axes. About
/// a third of all cases are undamaged; `damage` names what is wrong with the others. Needs the
/// recipe's outfit, garments and kind.
void sample_scan(CaseDice& dice, CaseRecipe& recipe);

}  // namespace regarment
