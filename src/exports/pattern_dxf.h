#pragma once

#include <string>

#include "garment/garment_template.h"

namespace regarment {

/// The flat pattern as a DXF file (AutoCAD R12, ASCII) by ASTM D6673 / AAMA 292, in millimetres,
/// y up. One block per panel (cut_piece.h), inserted side by side. Layers: 1 outline and piece
/// text, 2 turn points, 3 curve points, 4 notches (angle and depth of their points point inward),
/// 7 grain line, 8 construction lines, 14 seams, 15 remarks. Without seam allowance: the outline is
/// the sewing line, and a remark says so. Same input, same bytes. Throws InvalidInput when
/// `dimensions` make no garment.
std::string pattern_dxf(const GarmentTemplate& garment, const Dimensions& dimensions);

}  // namespace regarment
