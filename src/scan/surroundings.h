#pragma once

#include <optional>

#include "scan/body_frame.h"
#include "scan/scan.h"
#include "scan/separate_body.h"
#include "scan/weld.h"

namespace regarment {

/// Height of the floor sheet under the person's middle (the origin of `frame`), in the body frame,
/// m; nothing when no sheet lies level below. Several: the one with the most level normal.
std::optional<double> sheet_floor(std::span<const OuterSheet> sheets, const BodyFrame& frame);

/// What each vertex belongs to.
std::vector<Belongs> belongs_of_vertices(const SeparatedBody& separated, const Welded& welded);

/// Says what surrounds the person, with numbers of vertices: floor, walls, posts, islands, and
/// outliers, which are all other vertices marked in `scan.outlier` but those that are no numbers.
/// `belongs`: one per vertex; `sheets`: in the frame of the file.
void note_surroundings(std::span<const Belongs> belongs, std::span<const OuterSheet> sheets,
                       Scan& scan);

}  // namespace regarment
