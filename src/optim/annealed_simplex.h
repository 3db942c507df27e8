#pragma once

#include <Eigen/Core>
#include <functional>

#include "base/random.h"

namespace regarment {

struct AnnealedSimplexOptions {
  int max_evaluations = 500;  // of the function; at least dimension + 2
  // Temperature after the first simplex, as a share of the spread of its values. Larger leaves more
  // valleys and takes longer to come to rest; 0 is the plain method of Nelder and Mead.
  double start_temperature = 0.5;
  // Exponent of the cooling T = T0 (1 - k / K)^exponent at evaluation k. Larger cools earlier.
  double cooling_exponent = 1.0;
  // K as a share of `max_evaluations`, 0..1: what is left descends without temperature.
  double cooling_share = 0.7;
  // Ends a cooled search when the simplex's values differ by at most this share of the spread of
  // the first simplex's values, and its corners by at most `position_tolerance` of its edges.
  // Corners a tenth of that apart end it whatever their values: they then differ by noise alone.
  double value_tolerance = 1e-4;
  double position_tolerance = 1e-3;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// One evaluation of the function, in order.
struct SearchStep {
  int evaluation = 0;  // from 1
  Eigen::VectorXd at;
  double value = 0;        // infinity in place of a value that is not finite
  double best = 0;         // smallest value so far, this one included
  double temperature = 0;  // in units of the value; 0 while a simplex is made
};

enum class SearchEnding {
  Converged,       // came to rest, and a new simplex round the best point found nothing better
  EvaluationLimit  // max_evaluations were spent before that
};

struct SearchResult {
  Eigen::VectorXd at;  // where the smallest value was found
  double value = 0;    // infinity when no value was finite
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
/// turned round, or cut at the farther side of a narrow box. Trial points outside the box are moved
/// to its nearest point; sides may be infinite. A simplex that has become flat while it is warm is
/// made again, of the first size, round the best point so far. Once cooled, and each time the
/// simplex has come to rest, the search starts again round the best point so far, with edges half
/// as long as the time before, until that finds nothing better. `f` may be noisy or drift: a stored
/// value is only measured again by such a new start. A value that is not finite counts as larger
/// than any other. Same input and random state, same steps; a constant added to `f` or a factor
/// changes none.
///
/// Throws InvalidInput for options out of range, no dimension or sizes that do not match, a start
/// outside the box or not finite, an edge that is zero or not finite, a box without width. What `f`
/// and `observer` throw passes through.
SearchResult minimize_annealed(const std::function<double(const Eigen::VectorXd&)>& f,
                               const Eigen::VectorXd& start, const Eigen::VectorXd& edges,
                               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                               const AnnealedSimplexOptions& options, Random& random,
                               const SearchObserver& observer = {});

}  // namespace regarment
