#include "fit/garment_search.h"

#include <algorithm>
#include <utility>

#include "garment/hold_dimensions.h"

namespace regarment {

using Eigen::VectorXd;

Dimensions Setting::dimensions_at(const VectorXd& at) const {
  Dimensions out;
  Eigen::Index i = 0;
  for (const Dimension& d : garment.dimensions())
    if (!options.fixed.contains(d.name)) out[d.name] = at[i++];
  return nearest_holding(garment, out, options.fixed);
}

VectorXd Setting::per_dimension(const std::function<double(const Dimension&)>& value) const {
  std::vector<double> out;
  for (const Dimension& d : garment.dimensions())
    if (!options.fixed.contains(d.name)) out.push_back(value(d));
  return Eigen::Map<const VectorXd>(out.data(), static_cast<Eigen::Index>(out.size()));
}

Beginning near(const Setting& setting, const Dimensions& dimensions, Random& random) {
  const double share = setting.options.first_edge;
  Beginning out;
  out.at = setting.per_dimension([&](const Dimension& d) {
    const double moved = dimensions.at(d.name) * random.uniform(1 - share, 1 + share);
    return std::clamp(moved, d.lower, d.upper);
  });
  out.edges = setting.per_dimension([&](const Dimension& d) {
    return (random.uniform() < 0.5 ? -share : share) * dimensions.at(d.name);
  });
  return out;
}

Searched search(const Setting& setting, const Beginning& beginning,
                const AnnealedSimplexOptions& how, Random& random,
                const std::function<double(const ErrorTerms&)>& error,
                const SearchObserver& observer) {
  Trial trial = setting.new_trial();
  Searched out;
  const auto error_at = [&](const VectorXd& at) {
    FitEvaluation evaluation;
    if (setting.options.start_from_best && !out.particles.empty()) trial.start_from(out.particles);
    const Dimensions dimensions = setting.dimensions_at(at);
    for (const Dimension& d : setting.garment.dimensions())
      evaluation.dimensions.push_back(dimensions.at(d.name));
    evaluation.terms = trial.judge(dimensions);
    evaluation.error = error(evaluation.terms);
    evaluation.drape_steps = trial.outcome().steps;
    evaluation.came_to_rest = trial.outcome().ending == DrapeEnding::CameToRest;
    std::vector<FitEvaluation>& all = out.run.evaluations;
    if (all.empty() || evaluation.error < all[out.run.best].error) {
      out.run.best = all.size();
      out.dimensions = dimensions;
      out.particles = trial.cloth().positions;
      out.outcome = trial.outcome();
    }
    all.push_back(std::move(evaluation));
    return all.back().error;
  };
  const auto note = [&](const SearchStep& step) {
    out.run.evaluations.back().best = step.best;
    out.run.evaluations.back().temperature = step.temperature;
    observer(step);
  };
  const SearchResult found = minimize_annealed(
      error_at, beginning.at, beginning.edges,
      setting.per_dimension([](const Dimension& d) { return d.lower; }),
      setting.per_dimension([](const Dimension& d) { return d.upper; }), how, random, note);
  out.run.ending =
      found.ending == SearchEnding::Converged ? FitEnding::Converged : FitEnding::EvaluationLimit;
  return out;
}

}  // namespace regarment
