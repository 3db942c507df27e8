#include "report/result_search.h"

#include <cmath>

#include "base/error.h"
#include "fit/error_terms.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr double kMostError = 1e9;
constexpr int kErrorDigits = 6;    // significant
constexpr int kLengthDigits = 3;   // decimals of a centimetre
constexpr int kStretchDigits = 9;  // decimals

double significant(double value, const char* what) {
  if (!std::isfinite(value)) throw InvalidInput(std::string(what) + " is not a finite number");
  return rounded_significant(value, kErrorDigits);
}

double cm(double metres) {
  if (!std::isfinite(metres)) throw InvalidInput("a searched length is not a finite number");
  return rounded(metres * 100.0, kLengthDigits);
}

void check_run(const FitRun& run, std::size_t dimensions) {
  if (run.best >= run.evaluations.size()) {
    throw InvalidInput("a run's best evaluation is not among its evaluations");
  }
  const double best = run.evaluations[run.best].error;
  if (!(std::abs(best) < kMostError)) throw InvalidInput("a run's smallest error is not sensible");
  for (const FitEvaluation& evaluation : run.evaluations) {
    if (evaluation.dimensions.size() != dimensions) {
      throw InvalidInput("an evaluation must have one length per searched dimension");
    }
    for (const double length : evaluation.dimensions) cm(length);
    if (evaluation.error < best) throw InvalidInput("a run's best evaluation is not its best");
  }
}

ResultRun result_run(const FitRun& run) {
  const FitEvaluation& best = run.evaluations[run.best];
  ResultRun out;
  out.seed = run.seed;
  out.ending = run.ending;
  out.evaluations = run.evaluations.size();
  out.best = run.best + 1;
  for (const FitEvaluation& evaluation : run.evaluations) out.unsettled += !evaluation.came_to_rest;
  out.error = significant(best.error, "a run's error");
  for (const double length : best.dimensions) out.dimensions_cm.push_back(cm(length));
  return out;
}

}  // namespace

ResultSearch make_search(const GarmentAnalysis& garment, const GarmentTemplate& of) {
  const FitTrace& trace = garment.trace.value();
  if (trace.best_run >= trace.runs.size()) {
    throw InvalidInput("the best run of a trace is not among its runs");
  }
  ResultSearch out;
  for (const std::string& name : trace.names) {
    const Dimension& dimension = of.dimension(name);
    out.dimensions.push_back({name, cm(dimension.lower), cm(dimension.upper)});
  }
  out.weights = {significant(trace.weights.alpha, "alpha"), significant(trace.weights.beta, "beta"),
                 significant(trace.weights.gamma, "gamma")};
  out.square_root = trace.square_root;
  for (const FitRun& run : trace.runs) {
    check_run(run, trace.names.size());
    out.runs.push_back(result_run(run));
  }
  out.kept = trace.best_run + 1;
  for (const ResultRun& run : out.runs) {
    if (run.error < out.runs[trace.best_run].error) {
      throw InvalidInput("the best run of a trace does not have its smallest error");
    }
  }
  out.terms = {significant(garment.terms.distance, "the distance term"),
               // Its root is taken of what is left beside 1, so it needs more digits.
               rounded(garment.terms.stretch, kStretchDigits),
               significant(garment.terms.silhouette, "the silhouette term")};
  out.total = significant(total_error(garment.terms, trace.weights, trace.square_root), "E");
  return out;
}

ErrorTerms contributions(const ErrorTerms& terms, const ResultSearch& search) {
  const double off = std::abs(1.0 - terms.stretch);
  return {search.weights.alpha * terms.distance,
          search.weights.beta * (search.square_root ? std::sqrt(off) : off),
          search.weights.gamma * terms.silhouette};
}

}  // namespace regarment
