#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace regarment {

/// The terms of Eq. (1) [Hasler et al. 2007, sec. 3.3].
struct ErrorTerms {
  double distance = 0;    // E_dist, m, >= 0
  double stretch = 1;     // E_stretch, 1 when all springs have their rest length on average
  double silhouette = 0;  // E_sil, >= 0
};

/// alpha, beta and gamma of Eq. (1). Alpha is in 1/m so that E has no unit.
struct ErrorWeights {
  double alpha = 1, beta = 1, gamma = 1;
};

/// One evaluation of E.
struct FitEvaluation {
  std::vector<double> dimensions;  // m, in the template's order
  ErrorTerms terms;
  double error = 0;        // E
  double best = 0;         // smallest E of the run so far
  double temperature = 0;  // of the annealing, in units of E
  int drape_steps = 0;
  bool came_to_rest = true;
};

enum class FitEnding { Converged, EvaluationLimit };

/// One run of the search from one seed.
struct FitRun {
  std::uint64_t seed = 0;  // alone it gives the same run again
  FitEnding ending = FitEnding::EvaluationLimit;
  std::vector<FitEvaluation> evaluations;  // in order
  std::size_t best = 0;                    // index of the evaluation with the smallest error
};

/// All evaluations of a fit, for its report.
struct FitTrace {
  std::vector<std::string> names;  // of the dimensions, the template's order
  ErrorWeights weights;            // chosen once, before the runs, the same for all of them
  bool square_root = true;         // of the stretch term, as printed in Eq. (1)
  std::vector<FitRun> runs;
  std::size_t best_run = 0;  // the one with the smallest error, which was kept
};

}  // namespace regarment
