#include "fit/fit_garment.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <utility>

#include "base/error.h"
#include "fit/error_terms.h"
#include "fit/run_monitor.h"
#include "fit/trial.h"
#include "fit/weights.h"

namespace regarment {
namespace {

using Eigen::VectorXd;

/// What all runs share.
struct Setting {
  const GarmentTemplate& garment;
  const Dimensions& start;
  const Pattern& pattern;
  const std::vector<Vec3>& placed;
  const FitTarget& target;
  const std::vector<HeldEdge>& held;
  const FitOptions& options;

  Trial new_trial() const { return {garment, pattern, placed, target, held, options.drape}; }

  Dimensions dimensions_at(const VectorXd& at) const {
    Dimensions out;
    Eigen::Index i = 0;
    for (const Dimension& d : garment.dimensions()) out[d.name] = at[i++];
    return garment.nearest_possible(out);
  }

  VectorXd per_dimension(const std::function<double(const Dimension&)>& value) const {
    VectorXd out(static_cast<Eigen::Index>(garment.dimensions().size()));
    Eigen::Index i = 0;
    for (const Dimension& d : garment.dimensions()) out[i++] = value(d);
    return out;
  }
};

/// One run's search, and the drape at its best evaluation.
struct Searched {
  FitRun run;
  Dimensions dimensions;
  std::vector<Vec3> particles;
  DrapeOutcome outcome;
};

/// Where a search begins and how wide it looks at first.
struct Beginning {
  VectorXd at, edges;
};

/// Somewhere near `dimensions`, with edges up or down.
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

/// Searches for the smallest `error` of the terms, draping anew for each trial.
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

/// A rough size by E_dist alone, which needs no weights: what the weights are chosen at, and where
/// the runs begin.
Searched rough_search(const Setting& setting, const Progress& progress) {
  AnnealedSimplexOptions how = setting.options.search;
  const int simplex = static_cast<int>(setting.garment.dimensions().size()) + 2;
  how.max_evaluations =
      setting.options.rough_search ? std::max(simplex, setting.options.rough_evaluations) : simplex;
  how.start_temperature = 0;
  Random random(setting.options.seed);  // not asked at temperature zero: all seeds begin alike
  Beginning beginning;
  beginning.at =
      setting.per_dimension([&](const Dimension& d) { return setting.start.at(d.name); });
  beginning.edges = setting.options.first_edge * beginning.at;
  return search(
      setting, beginning, how, random, [](const ErrorTerms& terms) { return terms.distance; },
      [&](const SearchStep&) { progress.report("fit", 0.0, "a rough size first"); });
}

/// The terms of the better half of the rough search.
std::vector<ErrorTerms> terms_near_best(const FitRun& rough) {
  std::vector<FitEvaluation> all = rough.evaluations;
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.error < b.error; });
  all.resize((all.size() + 1) / 2);
  std::vector<ErrorTerms> out;
  for (const FitEvaluation& one : all) out.push_back(one.terms);
  return out;
}

Searched annealed_run(const Setting& setting, const Dimensions& rough, const ErrorWeights& weights,
                      int index, RunMonitor& monitor) {
  const std::uint64_t seed = setting.options.seed + static_cast<std::uint64_t>(index);
  Random random(seed);
  const Beginning beginning = near(setting, rough, random);
  Searched out = search(
      setting, beginning, setting.options.search, random,
      [&](const ErrorTerms& terms) {
        return total_error(terms, weights, setting.options.square_root);
      },
      [&](const SearchStep& step) { monitor.evaluated(index, step.evaluation, step.best); });
  out.run.seed = seed;
  return out;
}

/// All runs, on as many threads as allowed; which thread has which run changes nothing.
std::vector<Searched> search_all(const Setting& setting, const Dimensions& rough,
                                 const ErrorWeights& weights, const Progress& progress) {
  const int runs = setting.options.runs;
  std::vector<Searched> found(static_cast<std::size_t>(runs));
  std::vector<std::exception_ptr> failures(found.size());
  RunMonitor monitor(runs, setting.options.search.max_evaluations);
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next++; i < runs; i = next++) {
      try {
        found[static_cast<std::size_t>(i)] = annealed_run(setting, rough, weights, i, monitor);
      } catch (...) {
        failures[static_cast<std::size_t>(i)] = std::current_exception();
      }
      monitor.finished(i);
    }
  };
  {
    const int wanted = setting.options.threads > 0
                           ? setting.options.threads
                           : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::jthread> threads;
    for (int i = 0; i < std::min(wanted, runs); ++i) threads.emplace_back(work);
    monitor.watch(progress);
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return found;
}

double error_of(const FitRun& run) { return run.evaluations[run.best].error; }

}  // namespace

void FitOptions::check() const {
  drape.check();
  search.check();
  if (!(runs >= 1 && runs <= 100))
    throw InvalidInput("FitOptions: runs is " + std::to_string(runs) + "; it may be 1 to 100");
  if (!(threads >= 0 && threads <= 256))
    throw InvalidInput("FitOptions: threads is " + std::to_string(threads) +
                       "; it may be 0 to 256");
  if (!(first_edge > 0 && first_edge < 1))
    throw InvalidInput("FitOptions: first_edge is " + std::to_string(first_edge) +
                       "; it must lie between 0 and 1");
}

GarmentFit fit_garment(const GarmentTemplate& garment, const Dimensions& start,
                       const Pattern& pattern, const std::vector<Vec3>& placed,
                       const FitTarget& target, const std::vector<HeldEdge>& held,
                       const FitOptions& options, const Progress& progress) {
  options.check();
  const Setting setting{garment, start, pattern, placed, target, held, options};
  GarmentFit fit;
  for (const Dimension& d : garment.dimensions()) fit.trace.names.push_back(d.name);
  const Searched rough = rough_search(setting, progress);
  fit.trace.square_root = options.square_root;
  fit.trace.weights = balance(terms_near_best(rough.run));
  const Dimensions& first = options.rough_search ? rough.dimensions : start;
  std::vector<Searched> found = search_all(setting, first, fit.trace.weights, progress);
  const auto best = std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return error_of(a.run) < error_of(b.run);
  });
  fit.trace.best_run = static_cast<std::size_t>(best - found.begin());
  fit.dimensions = best->dimensions;
  fit.terms = best->run.evaluations[best->run.best].terms;
  fit.error = error_of(best->run);
  fit.draped = at_vertices(pattern, best->particles);
  fit.drape = best->outcome;
  for (Searched& one : found) fit.trace.runs.push_back(std::move(one.run));
  return fit;
}

}  // namespace regarment
