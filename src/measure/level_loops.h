#pragma once

#include <vector>

#include "measure/edge_evidence.h"

namespace regarment {

/// A level curve round a limb, a row of the evidence per column, with the evidence of all columns.
struct LevelLoop {
  std::vector<double> row;
  double score = 0;  // mean over the columns
};

/// The level curves of most evidence: s0 + a cos phi + b sin phi + c cos 2 phi, with a, b within
/// `search.tilt` and c from 0 to `search.dip`. Each column gives the best evidence within a
/// centimetre of the curve, less for what lies further from it. Curves whose mean heights lie
/// nearer than `kApart` are one. Best first, at most `most`.
std::vector<LevelLoop> level_loops(const EdgeEvidence& evidence, const LimbMap& map,
                                   const EdgeSearch& search, int most);

/// Takes away the evidence further than `rows` rows from the loop.
void keep_near(const LevelLoop& loop, double rows, EdgeEvidence& evidence);

inline constexpr double kApart = 0.025;   // m, loops nearer than this are one edge
inline constexpr double kLeftOut = -2.0;  // evidence where no loop may lie

}  // namespace regarment
