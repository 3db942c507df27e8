#include "optim/annealed_simplex.h"

#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "optim/simplex_search.h"

namespace regarment {
namespace {

using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRestart = 0.5;  // edges of a new simplex over those of the one before

void require(bool right, const std::string& what) {
  if (!right) throw InvalidInput("minimize_annealed: " + what);
}

void check_input(const VectorXd& start, const VectorXd& edges, const VectorXd& lower,
                 const VectorXd& upper, const AnnealedSimplexOptions& options) {
  options.check();
  const Eigen::Index n = start.size();
  require(n > 0, "there is no dimension to search");
  require(edges.size() == n && lower.size() == n && upper.size() == n,
          "start has " + std::to_string(n) + " dimensions, edges " + std::to_string(edges.size()) +
              ", lower " + std::to_string(lower.size()) + ", upper " +
              std::to_string(upper.size()));
  require(options.max_evaluations >= n + 2,
          "max_evaluations is " + std::to_string(options.max_evaluations) + ", " +
              std::to_string(n) + " dimensions need at least " + std::to_string(n + 2));
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::string at = " in dimension " + std::to_string(i);
    require(lower[i] < upper[i], "the box has no width" + at);
    require(std::isfinite(start[i]) && start[i] >= lower[i] && start[i] <= upper[i],
            "the start " + std::to_string(start[i]) + " is not in the box" + at);
    require(std::isfinite(edges[i]) && edges[i] != 0,
            "the edge is " + std::to_string(edges[i]) + at);
  }
}

}  // namespace

void AnnealedSimplexOptions::check() const {
  const auto in = [](const char* field, double value, bool right) {
    if (!right)
      throw InvalidInput(std::string("AnnealedSimplexOptions: ") + field + " is " +
                         std::to_string(value));
  };
  in("max_evaluations", max_evaluations, max_evaluations >= 3);
  in("start_temperature", start_temperature,
     std::isfinite(start_temperature) && start_temperature >= 0);
  in("cooling_exponent", cooling_exponent, std::isfinite(cooling_exponent) && cooling_exponent > 0);
  in("cooling_share", cooling_share, cooling_share >= 0 && cooling_share <= 1);
  in("value_tolerance", value_tolerance, std::isfinite(value_tolerance) && value_tolerance >= 0);
  in("position_tolerance", position_tolerance,
     std::isfinite(position_tolerance) && position_tolerance >= 0);
}

SearchResult minimize_annealed(const std::function<double(const VectorXd&)>& f,
                               const VectorXd& start, const VectorXd& edges, const VectorXd& lower,
                               const VectorXd& upper, const AnnealedSimplexOptions& options,
                               Random& random, const SearchObserver& observer) {
  check_input(start, edges, lower, upper, options);
  SimplexSearch search(f, edges, lower, upper, options, random, observer);
  search.start(start);
  double share = 1;
  if (search.warm()) {
    while (search.warm() && !search.spent()) {
      search.move();
      if (search.flat()) search.restart(1);
    }
    search.restart(share *= kRestart);
  }
  SearchEnding ending = SearchEnding::EvaluationLimit;
  double before = kInfinity;  // best value when the simplex last came to rest
  while (!search.spent()) {
    if (!search.at_rest()) {
      search.move();
    } else if (before - search.best().value <= search.value_tolerance()) {
      ending = SearchEnding::Converged;
      break;
    } else {
      before = search.best().value;
      search.restart(share *= kRestart);
    }
  }
  return {search.best().at, search.best().value, search.evaluations(), ending};
}

}  // namespace regarment
