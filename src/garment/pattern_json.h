#pragma once

#include <string>

#include "garment/garment_template.h"

namespace regarment {

/// The flat pattern as a GarmentCode specification (JSON text, ends with a newline): centimetres
/// (units_in_meter 100), y up, panels with vertices, edges and relative curvature, stitches,
/// dimensions as parameters. Panels are whole, also where they are cut on the fold; free edges
/// carry their name as label; an elliptic edge is written as a cubic. Same input, same bytes.
/// Throws InvalidInput when `dimensions` make no garment.
std::string pattern_json(const GarmentTemplate& garment, const Dimensions& dimensions);

}  // namespace regarment
