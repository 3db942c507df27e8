#pragma once

#include <functional>
#include <vector>

#include "fit/fit_garment.h"
#include "fit/trial.h"

namespace regarment {

/// What all searches of a fit share. Borrows everything.
struct Setting {
  const GarmentTemplate& garment;
  const Dimensions& start;
  const Pattern& pattern;
  const std::vector<Vec3>& placed;
  const FitTarget& target;
  const std::vector<HeldEdge>& held;
  const FitOptions& options;

  Trial new_trial() const { return {garment, pattern, placed, target, held, options.drape}; }

  /// The garment nearest to a point of the search that can be made, with what is fixed.
  Dimensions dimensions_at(const Eigen::VectorXd& at) const;
  /// One value per dimension that is searched, in the template's order.
  Eigen::VectorXd per_dimension(const std::function<double(const Dimension&)>& value) const;
};

/// A search that is over, and the drape at its best evaluation.
struct Searched {
  FitRun run;
  Dimensions dimensions;
  std::vector<Vec3> particles;
  DrapeOutcome outcome;
};

/// Where a search begins and how wide it looks at first.
struct Beginning {
  Eigen::VectorXd at, edges;
};

/// Somewhere near `dimensions`, each edge up or down, by `random`.
Beginning near(const Setting& setting, const Dimensions& dimensions, Random& random);

/// Searches for the dimensions with the smallest `error` of the terms of Eq. (1), draping anew for
/// each trial. `observer` is told of each evaluation and may throw to end the search.
Searched search(const Setting& setting, const Beginning& beginning,
                const AnnealedSimplexOptions& how, Random& random,
                const std::function<double(const ErrorTerms&)>& error,
                const SearchObserver& observer);

}  // namespace regarment
