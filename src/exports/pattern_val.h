#pragma once

#include <string>

#include "garment/garment_template.h"

namespace regarment {

/// The flat pattern as a Valentina document (.val, format 0.8.8), in centimetres: per panel
/// (cut_piece.h) one drawing with its corners as points given by length and angle from the first,
/// its curves as cubic splines, and one detail with grain line, notches and label, without seam
/// allowance. The garment's dimensions stand in the table of increments. Notches inside a curved
/// edge are left out. Same input, same bytes. Throws InvalidInput when `dimensions` make no
/// garment.
std::string pattern_val(const GarmentTemplate& garment, const Dimensions& dimensions);

}  // namespace regarment
