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
  const FitOptions& options;

  Trial new_trial() const { return {garment, pattern, placed, target, options.drape}; }

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

/// Judges the start and each dimension somewhat longer and shorter, for the weights of Eq. (1).
std::vector<ErrorTerms> sample_terms(const Setting& setting, const Progress& progress) {
  Trial trial = setting.new_trial();
  std::vector<ErrorTerms> samples = {trial.judge(setting.start, progress)};
  for (const Dimension& d : setting.garment.dimensions())
    for (const double factor : {1 + setting.options.first_edge, 1 - setting.options.first_edge}) {
      progress.report("fit", 0.0, "weighing the terms of the error");
      Dimensions moved = setting.start;
      moved[d.name] *= factor;
      samples.push_back(trial.judge(setting.garment.nearest_possible(moved), progress));
    }
  return samples;
}

Searched search(const Setting& setting, const ErrorWeights& weights, int index,
                RunMonitor& monitor) {
  const FitOptions& options = setting.options;
  Trial trial = setting.new_trial();
  Searched out;
  out.run.seed = options.seed;
  Random random(options.seed, static_cast<std::uint32_t>(index));
  const VectorXd lower = setting.per_dimension([](const Dimension& d) { return d.lower; });
  const VectorXd upper = setting.per_dimension([](const Dimension& d) { return d.upper; });
  const VectorXd start = setting.per_dimension([&](const Dimension& d) {
    const double moved = random.uniform(1 - options.first_edge, 1 + options.first_edge);
    return std::clamp(setting.start.at(d.name) * moved, d.lower, d.upper);
  });
  const VectorXd edges = setting.per_dimension([&](const Dimension& d) {
    const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
    return sign * options.first_edge * setting.start.at(d.name);
  });

  const auto error_at = [&](const VectorXd& at) {
    FitEvaluation evaluation;
    const Dimensions dimensions = setting.dimensions_at(at);
    for (const Dimension& d : setting.garment.dimensions())
      evaluation.dimensions.push_back(dimensions.at(d.name));
    evaluation.terms = trial.judge(dimensions);
    evaluation.error = total_error(evaluation.terms, weights, options.square_root);
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
    monitor.evaluated(index, step.evaluation, step.best);
  };
  const SearchResult found =
      minimize_annealed(error_at, start, edges, lower, upper, options.search, random, note);
  out.run.ending =
      found.ending == SearchEnding::Converged ? FitEnding::Converged : FitEnding::EvaluationLimit;
  return out;
}

/// All runs, on as many threads as allowed; which thread has which run changes nothing.
std::vector<Searched> search_all(const Setting& setting, const ErrorWeights& weights,
                                 const Progress& progress) {
  const int runs = setting.options.runs;
  std::vector<Searched> found(static_cast<std::size_t>(runs));
  std::vector<std::exception_ptr> failures(found.size());
  RunMonitor monitor(runs, setting.options.search.max_evaluations);
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next++; i < runs; i = next++) {
      try {
        found[static_cast<std::size_t>(i)] = search(setting, weights, i, monitor);
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
                       const FitTarget& target, const FitOptions& options,
                       const Progress& progress) {
  options.check();
  const Setting setting{garment, start, pattern, placed, target, options};
  GarmentFit fit;
  for (const Dimension& d : garment.dimensions()) fit.trace.names.push_back(d.name);
  fit.trace.weights = balance(sample_terms(setting, progress));
  std::vector<Searched> found = search_all(setting, fit.trace.weights, progress);
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
  progress.report("fit", 1.0);
  return fit;
}

}  // namespace regarment
