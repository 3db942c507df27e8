#pragma once

#include <string>
#include <vector>

#include "garment/pattern.h"
#include "scan/scan.h"

namespace regarment {

/// A closed line along the border of a garment's label.
struct BorderLine {
  std::string edge;          // which edge of the pattern it follows: "hem"
  std::vector<Vec3> points;  // body frame, m, about 5 mm apart; closed, first not repeated
  double shown = 0;  // 0..1, share of the points beside which the label does end; the others
                     // bridge holes and what other garments cover
};

/// Lines along which the label `layer` ends, one for each open edge of the garment: the edge as
/// draped, moved to where the label ends within 3 cm of it (beside another label, where an open
/// mesh ends, or at the rim of a cloud's points), and smoothed over a centimetre so that single
/// vertices do not show. Edges beside which the label ends nowhere are left out.
///
/// `label`: one per scan vertex. `draped`: one position per pattern vertex, body frame, m. Throws
/// InvalidInput for sizes that do not match.
std::vector<BorderLine> border_lines(const Scan& scan, const std::vector<std::uint8_t>& label,
                                     int layer, const Pattern& pattern,
                                     const std::vector<Vec3>& draped);

}  // namespace regarment
