#pragma once

#include <vector>

#include "measure/edge_finder.h"

namespace regarment {

/// What lies on both sides of one boundary between rows of a limb's map.
struct EdgeBoundary {
  double step = 0;       // m, garment surface minus the other at the boundary
  double garment_r = 0;  // m, garment surface extrapolated to the boundary
  double contrast = 0;   // colour difference across it, 0..1.7; 0 where the garment goes on beyond
                         // in colours that it has itself, as stripes do
  bool drop = false;     // cloth on one side, nothing on the other
  double filled = 1;     // share of the garment's rows that hold data: all of them beside a drop
  bool valid = false;
};

/// How much each boundary between rows `low` .. `low + rows - 1` of a limb's map looks like the
/// edge searched for. Column by column: entry i of column j is at j * rows + i.
struct EdgeEvidence {
  int low = 0, rows = 0, columns = 0;
  std::vector<EdgeBoundary> boundary;
  std::vector<double> score;  // -1..2; 1 is a step of cloth thickness

  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(rows) +
           static_cast<std::size_t>(i);
  }
};

/// Looks at every boundary in the range of the search: a smooth surface with a step is fitted to
/// the rows on both sides, and colours are compared. `rows` is below 3 when the range holds none.
EdgeEvidence edge_evidence(const LimbMap& map, const EdgeSearch& search);

/// Evidence of a colour difference across an edge, 0..2.
double colour_evidence(double contrast);

inline constexpr double kFullContrast = 0.12;  // colour difference that is fully convincing
inline constexpr double kSeenShare = 0.3;      // of full evidence: the column shows the edge

}  // namespace regarment
