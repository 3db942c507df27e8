#pragma once

#include "synthetic/case_dice.h"
#include "synthetic/fabric.h"

namespace regarment {

/// Draws what a garment is made of: thin jersey, woven cotton, heavy denim or wool, thick fleece.
/// `thick` 0 .. 1 chooses among them, thin to thick; `thickest` (m) holds for what is worn over or
/// under something.
SheetFabric sample_fabric(double thick, double thickest, CaseDice& dice);

}  // namespace regarment
