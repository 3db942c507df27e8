#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/analysis.h"

namespace regarment {

/// A dimension that was searched for.
struct SearchedDimension {
  std::string name;
  double lower_cm = 0, upper_cm = 0;  // the template's bounds, lower < upper
};

/// One run of a search, in short. Its evaluations stand in evaluations-I.csv.
struct ResultRun {
  std::uint64_t seed = 0;
  FitEnding ending = FitEnding::EvaluationLimit;
  std::size_t evaluations = 0;        // >= 1
  std::size_t best = 1;               // the evaluation with the smallest error, from 1 on
  std::size_t unsettled = 0;          // drapes that were stopped before they came to rest
  double error = 0;                   // E at `best`
  std::vector<double> dimensions_cm;  // there, one per searched dimension
};

/// How the dimensions of a garment were searched for.
struct ResultSearch {
  std::vector<SearchedDimension> dimensions;  // the template's order
  ErrorWeights weights;
  bool square_root = true;      // of the stretch term
  std::vector<ResultRun> runs;  // >= 1
  std::size_t kept = 1;         // the run whose result this is, from 1 on
  double total = 0;             // E at the result
  ErrorTerms terms;             // its terms there, not weighted
};

/// The search of a garment that has a trace. Lengths are rounded to 0.01 mm, errors to six digits.
/// Throws InvalidInput when the trace contradicts itself: no run, a run without evaluations, sizes
/// that differ, a best evaluation that is not the best or has no finite error.
ResultSearch make_search(const GarmentAnalysis& garment, const GarmentTemplate& of);

/// The weighted terms of Eq. (1), which add up to E: distance, stretch, silhouette.
ErrorTerms contributions(const ErrorTerms& terms, const ResultSearch& search);

}  // namespace regarment
