#pragma once

#include <string>

#include "garment/cut_piece.h"

namespace regarment {

/// The `draw` element of one piece in a Valentina document. Internal to this library.
/// `next_id` is the next free number of an object and is moved on; `prefix` begins the names of its
/// points; the piece's left upper corner lies at `corner` (cm, y down).
std::string val_drawing(const CutPiece& piece, const std::string& prefix, const Vec2& corner,
                        int& next_id);

}  // namespace regarment
