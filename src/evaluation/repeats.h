#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluated_scan.h"

namespace regarment {

/// One dimension of one garment, found on several scans of it. Centimetres.
struct RepeatedDimension {
  std::string garment;  // as EvaluationCase::garment
  std::string key;      // of the measurement, "skirt.hip"; see measurement_key
  std::string name;     // the same for a person
  double truth_cm = 0;
  std::vector<std::string> scans;  // names, at least two
  std::vector<double> errors_cm;   // one per scan
  double mean_error_cm = 0;        // of the estimates pooled: their mean less the truth
  double sd_cm = 0;                // of the estimates, n - 1
  double range_cm = 0;             // largest less smallest
};

/// The repeats of one measurement over all garments. Centimetres.
struct RepeatSummary {
  std::string key, name;  // as above
  std::size_t garments = 0, scans = 0;
  double within_sd_cm = 0;   // pooled over garments: root of sum (n - 1) SD^2 / sum (n - 1)
  double single_mae_cm = 0;  // mean absolute error of the single scans
  double pooled_mae_cm = 0;  // and of the garments' means
};

/// Dimensions that two or more scans of a garment show and that were found on them, in the order of
/// the scans. Hidden ones and those whose truths differ by more than 0.01 cm (another garment under
/// the same name) are left out.
std::vector<RepeatedDimension> repeated_dimensions(const std::vector<EvaluatedScan>& scans);

/// By measurement, sorted by key.
std::vector<RepeatSummary> repeat_summaries(const std::vector<RepeatedDimension>& repeats);

}  // namespace regarment
