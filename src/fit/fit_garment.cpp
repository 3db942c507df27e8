#include "fit/fit_garment.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

#include "base/error.h"
#include "fit/error_terms.h"
#include "fit/garment_search.h"
#include "fit/run_monitor.h"
#include "fit/weights.h"

namespace regarment {
namespace {

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
  out.reserve(all.size());
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
    const int used = std::min(wanted, runs);
    threads.reserve(static_cast<std::size_t>(used));
    for (int i = 0; i < used; ++i) threads.emplace_back(work);
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
  if (!(rough_evaluations >= 1 && rough_evaluations <= 100'000))
    throw InvalidInput("FitOptions: rough_evaluations is " + std::to_string(rough_evaluations) +
                       "; it may be 1 to 100000");
  if (!(silhouette_size >= 16 && silhouette_size <= 4096))
    throw InvalidInput("FitOptions: silhouette_size is " + std::to_string(silhouette_size) +
                       "; it may be 16 to 4096");
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
  fit.trace.weights = balance(terms_near_best(rough.run), options.square_root);
  const Dimensions& first = options.rough_search ? rough.dimensions : start;
  std::vector<Searched> found = search_all(setting, first, fit.trace.weights, progress);
  const auto best = std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return error_of(a.run) < error_of(b.run);
  });
  fit.trace.best_run = static_cast<std::size_t>(best - found.begin());
  fit.dimensions = best->dimensions;
  fit.terms = best->run.evaluations[best->run.best].terms;
  if (fit.terms.silhouette >= unseen_error(target.silhouettes()))
    throw NoGarmentError("no drape of the " + garment.name() +
                         " stayed on the scan; check the scan's units and axes");
  fit.error = error_of(best->run);
  fit.draped = at_vertices(pattern, best->particles);
  fit.drape = best->outcome;
  for (Searched& one : found) fit.trace.runs.push_back(std::move(one.run));
  return fit;
}

}  // namespace regarment
