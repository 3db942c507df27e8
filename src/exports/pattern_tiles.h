#pragma once

#include <string>

#include "garment/garment_template.h"

namespace regarment {

/// The flat pattern in real size as a PDF to print on A4 and glue together. A first page with the
/// pieces to cut, the measurements, a test square of 10 cm and a map of the pages; then the pieces
/// in tiles of 180 x 250 mm, which also fit on US Letter, framed, numbered and with marks that meet
/// their neighbours'. Pieces that are alike are drawn once; one cut on the fold is drawn half.
/// Notches, seams, grain line and construction lines are shown; there is no seam allowance, and it
/// says so. Same input, same bytes. Throws InvalidInput when `dimensions` make no garment.
std::string pattern_tiles(const GarmentTemplate& garment, const Dimensions& dimensions);

}  // namespace regarment
