#pragma once

#include <string>
#include <vector>

#include "report/result_search.h"

namespace regarment {

/// evaluations-I.csv: one row per evaluation, run by run, with the columns run and evaluation (from
/// 1 on), NAME_cm for each searched dimension, distance_m, stretch, silhouette, error, best,
/// temperature, drape_steps, came_to_rest. What has no finite value, or one beyond 1e9, is empty.
std::string evaluations_csv(const FitTrace& trace);

/// The evaluations of one run, as its charts show them: each vector has one entry per evaluation.
struct RunEvaluations {
  std::vector<std::vector<double>> dimensions_cm;  // one vector per searched dimension
  std::vector<ErrorTerms> terms;                   // NaN where there is none
  std::vector<double> error;                       // E, NaN where there is none
};

/// Reads it back. Throws ReadError naming line and column when the table is not the one of this
/// search: columns or rows are missing, too many or out of order, a cell is no number of sensible
/// size, or the smallest error of a run is not where the search says.
std::vector<RunEvaluations> read_evaluations(const std::string& csv, const std::string& name,
                                             const ResultSearch& search);

}  // namespace regarment
