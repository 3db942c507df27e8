#pragma once

#include <cstdint>
#include <vector>

#include "fill/edge_loop.h"
#include "geometry/closest_point.h"

namespace regarment {

/// A closed outline of a hole in a scan under a garment, the hole on the left seen from outside:
/// vertices of the scan's border, and where the hole runs out under the garment's own open edge,
/// new points on that edge.
struct HoleOutline {
  static constexpr std::uint32_t kNew = 0xffffffff;

  std::vector<Vec3> points;             // m
  std::vector<std::uint32_t> vertices;  // per point: the scan's vertex, or kNew
};

/// What the search for holes looks at. Views into the caller's data.
struct HoleSearch {
  const std::vector<Vec3>& positions;                    // of the welded scan, m
  const std::vector<std::vector<std::uint32_t>>& loops;  // as border_loops gives them
  const std::vector<std::uint8_t>& labels;               // per position
  std::uint8_t label = 1;                                // of the garment
  const std::vector<EdgeLoop>& edges;                    // its open edges, garment on their left
};

/// The holes of a scan under one garment.
///
/// A border loop that follows an open edge of the garment backwards (the garment on its right) is
/// the scan's natural end there and no hole. Where such a loop leaves the edge to go round missing
/// cloth, the outline follows the border there and comes back along the garment's edge. Border that
/// belongs to the person or to another garment is left out in the same way. A hole all round a
/// limb, which has two loops and no way between them, is not found.
std::vector<HoleOutline> hole_outlines(const HoleSearch& search);

}  // namespace regarment
