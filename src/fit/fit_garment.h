#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "drape/drape.h"
#include "fit/fit_target.h"
#include "fit/fit_trace.h"
#include "garment/garment_template.h"
#include "optim/annealed_simplex.h"

namespace regarment {

struct FitOptions {
  DrapeOptions drape;
  AnnealedSimplexOptions search;
  int runs = 3;  // from different seeds; the smallest error is kept [sec. 4]
  std::uint64_t seed = 1;
  int threads = 0;  // at most; 0: as many as the machine has
  // A first search of `rough_evaluations` drapes by E_dist alone, which needs no weights: these are
  // chosen near its result, and the runs begin there. False: at the starting dimensions.
  bool rough_search = true;
  int rough_evaluations = 60;
  double first_edge = 0.1;    // edges of the first simplex, share of each dimension
  int silhouette_size = 256;  // pixels
  // Each drape starts from the best one of its run so far; false: from the one before, as printed,
  // which cloth wrecked by a bad trial does not survive.
  bool start_from_best = true;
  bool square_root = true;  // of the stretch term, as printed in Eq. (1)
  Dimensions fixed;  // m, by name: not searched but held; at least one dimension is left to search

  void check() const;  // throws InvalidInput naming the field and its value
};

/// A garment fitted by the paper's search.
struct GarmentFit {
  FitTrace trace;
  Dimensions dimensions;  // of the best evaluation of the best run, m
  ErrorTerms terms;       // there
  double error = 0;
  std::vector<Vec3> draped;  // the garment there, body frame, m, one per pattern vertex
  DrapeOutcome drape;        // how that drape ended
};

/// Finds the dimensions with the smallest error of Eq. (1), by draping the garment again for each
/// trial [Hasler et al. 2007, sec. 3.3]. `placed`: where `pattern`, at its starting dimensions,
/// lies on the body (place_garment). `held`: edges whose place on the scan is known. The drape of a
/// trial starts from that of the trial before. Progress says run, evaluation, smallest error and
/// the time left. The same bytes for any number of threads. Throws NoGarmentError when no drape
/// shows a silhouette, UsageError when no garment has the dimensions that are fixed, InvalidInput,
/// Stopped.
GarmentFit fit_garment(const GarmentTemplate& garment, const Dimensions& start,
                       const Pattern& pattern, const std::vector<Vec3>& placed,
                       const FitTarget& target, const std::vector<HeldEdge>& held,
                       const FitOptions& options, const Progress& progress = {});

}  // namespace regarment
