#pragma once

#include <Eigen/Core>
#include <functional>

#include "base/random.h"

namespace regarment {

struct AnnealedSimplexOptions {
  int max_evaluations = 500;  // of the function; at least dimension + 2
  // Temperature of the first move as a share of the spread of the values over the first simplex.
  // Larger leaves more valleys and takes longer to come to rest.
  double start_temperature = 0.5;
  // Exponent of the cooling T = T0 (1 - k / K)^exponent over the K evaluations. Larger cools
  // earlier.
  double cooling_exponent = 2.0;
  // Ends a cooled search when the simplex's values differ by less than this share of their mean
  // size, and its corners by less than `position_tolerance` of the first simplex's edges.
  double value_tolerance = 1e-4;
  double position_tolerance = 1e-3;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// One evaluation of the function, in order.
struct SearchStep {
  int evaluation = 0;  // from 1
  Eigen::VectorXd at;
  double value = 0;
  double best = 0;         // smallest value so far, this one included
  double temperature = 0;  // in units of the value
};

enum class SearchEnding { Converged, EvaluationLimit };

struct SearchResult {
  Eigen::VectorXd at;  // where the smallest value was found
  double value = 0;
  int evaluations = 0;
  SearchEnding ending = SearchEnding::EvaluationLimit;
};

/// Called after each evaluation; may throw to end the search.
using SearchObserver = std::function<void(const SearchStep&)>;

/// Smallest value of `f` in the box lower <= x <= upper: the downhill simplex of Nelder and Mead
/// (1965) with simulated annealing, as described by Press et al., Numerical Recipes, sec. 10.9
/// (paper, sec. 3.3): corners are seen worse, trial points better than they are by a random amount
/// of the order of the temperature, so that a step uphill is sometimes taken.
///
/// The first simplex is `start` and `start + edge_i e_i`; an edge that would leave the box is
/// turned round. Trial points outside the box are moved to its nearest point. `f` may be noisy; a
/// value that is not finite counts as larger than any other. Same input and random state, same
/// steps.
/// Throws InvalidInput for sizes that do not match, a start outside the box, an edge that is zero
/// or not finite.
SearchResult minimize_annealed(const std::function<double(const Eigen::VectorXd&)>& f,
                               const Eigen::VectorXd& start, const Eigen::VectorXd& edges,
                               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                               const AnnealedSimplexOptions& options, Random& random,
                               const SearchObserver& observer = {});

}  // namespace regarment
