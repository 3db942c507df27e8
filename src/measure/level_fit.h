#pragma once

#include <vector>

#include "measure/cloth_levels.h"

namespace regarment {

/// A girth read off the girths of many levels.
struct FittedGirth {
  double value = 0;    // m
  double spread = 0;   // m, how far the levels stray from what was fitted to them
  double unseen = 0;   // m, what was added because levels seem to miss cloth
  double bridged = 0;  // share of the levels fitted that runs over gaps
  bool found = false;
};

/// The girth at level `t`, where the garment may be cut at an angle: a robust line on either side
/// of it, meeting there, through the levels within `window` (m). With fewer than three levels on
/// one side, one line. Not found with fewer than three in all.
FittedGirth girth_at_level(const std::vector<LevelGirth>& levels, double t, double window);

/// The girth at level `t` of a piece of cloth with straight sides from level `start` on, whose
/// girth there is `girth_at_start`: it grows linearly on the flat garment. Folds that a scan does
/// not see into make levels too short, never too long: what counts is the steepest growth that
/// several levels agree on. Not found with fewer than four levels between.
FittedGirth girth_of_straight_piece(const std::vector<LevelGirth>& levels, double start,
                                    double girth_at_start, double t);

}  // namespace regarment
