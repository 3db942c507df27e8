#pragma once

#include <optional>

#include "scan/body_frame.h"
#include "scan/scan.h"
#include "scan/separate_body.h"
#include "scan/weld.h"

namespace regarment {

/// Height of the floor sheet under the person's middle (the origin of `frame`), in the body frame,
/// m; nothing when no sheet lies level below. Several: the one with the most level normal.
std::optional<double> sheet_floor(const SeparatedBody& separated, const BodyFrame& frame);

/// Says what surrounds the person, with numbers of vertices: floor, walls, posts, islands, and
/// outliers, which are all other vertices marked in `scan.outlier` but those that are no numbers.
void note_surroundings(const SeparatedBody& separated, const Welded& welded, Scan& scan);

}  // namespace regarment
