#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyses.h"
#include "base/random.h"
#include "fit/error_terms.h"

// Searches made up for tests: a tiny one to be checked by hand, and a long one that looks like the
// real thing.

namespace regarment {

/// Two runs over one dimension, alpha = beta = gamma = 1 and no root, so that all sums are plain.
/// Run 1 tries lengths 50, 60, 55 cm with errors 0.5, 0.25, 0.375; run 2 tries 40 and 45 cm, the
/// first without a silhouette, the second with error 0.125, the best.
inline FitTrace tiny_trace() {
  const auto evaluation = [](double length, double distance, double silhouette) {
    FitEvaluation e;
    e.dimensions = {length};
    e.terms = {distance, 1.0, silhouette};
    e.error = distance + silhouette;
    e.temperature = 0.01;
    e.drape_steps = 7;
    return e;
  };
  FitTrace trace;
  trace.names = {"length"};
  trace.square_root = false;
  trace.runs.resize(2);
  trace.runs[0].seed = 11;
  trace.runs[0].ending = FitEnding::Converged;
  trace.runs[0].evaluations = {evaluation(0.5, 0.25, 0.25), evaluation(0.6, 0.125, 0.125),
                               evaluation(0.55, 0.125, 0.25)};
  trace.runs[0].evaluations[1].came_to_rest = false;
  trace.runs[0].best = 1;
  trace.runs[1].seed = 12;
  const double none = std::numeric_limits<double>::infinity();
  trace.runs[1].evaluations = {evaluation(0.4, 0.125, none), evaluation(0.45, 0.0625, 0.0625)};
  trace.runs[1].best = 1;
  trace.best_run = 1;
  const double best[] = {0.5, 0.25, 0.25};
  for (std::size_t i = 0; i < 3; ++i) trace.runs[0].evaluations[i].best = best[i];
  trace.runs[1].evaluations[0].best = none;
  trace.runs[1].evaluations[1].best = 0.125;
  return trace;
}

/// One made-up evaluation at these dimensions: the terms grow with the distance from `target`.
inline FitEvaluation made_evaluation(const std::vector<double>& at,
                                     const std::vector<double>& target, Random& random) {
  double off = 0.0;
  for (std::size_t d = 0; d < at.size(); ++d) off += std::abs(at[d] / target[d] - 1.0);
  FitEvaluation e;
  e.dimensions = at;
  e.terms.distance = 0.0015 + 0.004 * off * (1.0 + 0.2 * random.uniform());
  e.terms.stretch = 1.0 + 0.03 * off + 0.002 * random.normal();
  e.terms.silhouette = 0.2 + 0.8 * off * (1.0 + 0.3 * random.uniform());
  e.drape_steps = 100 + static_cast<int>(200.0 * random.uniform());
  e.came_to_rest = random.uniform() > 0.02;
  return e;
}

/// A run that wanders less and less about what it has found. `target` is what it is after.
inline FitRun made_run(const std::vector<double>& start, const std::vector<double>& target,
                       const ErrorWeights& weights, int evaluations, std::uint64_t seed) {
  Random random(seed);
  FitRun run;
  run.seed = seed;
  std::vector<double> best = start;
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < evaluations; ++i) {
    const double left = 1.0 - double(i) / evaluations;
    std::vector<double> at = best;
    for (double& length : at) length *= 1.0 + (0.005 + 0.12 * left * left) * random.normal();
    FitEvaluation e = made_evaluation(at, target, random);
    e.error = total_error(e.terms, weights);
    e.temperature = 0.002 * left * left;
    if (e.error < smallest) {
      smallest = e.error;
      best = at;
      run.best = run.evaluations.size();
    }
    e.best = smallest;
    run.evaluations.push_back(e);
  }
  return run;
}

/// `runs` runs over all dimensions of a template from its typical values.
inline FitTrace made_trace(const GarmentTemplate& garment, int runs, int evaluations) {
  FitTrace trace;
  trace.weights = {1.0, 0.012, 0.0075};
  std::vector<double> start, target;
  for (const Dimension& dimension : garment.dimensions()) {
    trace.names.push_back(dimension.name);
    start.push_back(dimension.typical);
    target.push_back(dimension.typical * 1.12);
  }
  for (int r = 0; r < runs; ++r) {
    const int length = r == 1 ? evaluations * 3 / 5 : evaluations;
    trace.runs.push_back(
        made_run(start, target, trace.weights, length, static_cast<std::uint64_t>(r) + 1));
    if (r == 1) trace.runs.back().ending = FitEnding::Converged;
    const auto smallest = [&](std::size_t i) {
      return trace.runs[i].evaluations[trace.runs[i].best].error;
    };
    if (smallest(trace.runs.size() - 1) < smallest(trace.best_run)) {
      trace.best_run = trace.runs.size() - 1;
    }
  }
  return trace;
}

/// Gives a garment this search as its own.
inline void set_trace(const FitTrace& trace, GarmentAnalysis& garment) {
  const FitRun& run = trace.runs[trace.best_run];
  garment.terms = run.evaluations[run.best].terms;
  garment.trace = trace;
}

/// A deviation for the vertices labelled `label`: `value(i)` in m.
template <class Value>
void set_deviation(Analysis& analysis, std::size_t garment, const Value& value) {
  std::vector<float>& out = analysis.garments[garment].deviation;
  out.assign(analysis.labels.size(), std::nanf(""));
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (analysis.labels[i] == garment + 1) out[i] = static_cast<float>(value(i));
  }
}

}  // namespace regarment
