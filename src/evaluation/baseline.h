#pragma once

#include <map>
#include <optional>
#include <string>

#include "evaluation/evaluation.h"

namespace regarment {

/// An evaluation of before, as far as it is compared.
struct Baseline {
  std::string file;                                    // its name
  std::map<std::string, double> statistics;            // by full_name
  std::map<std::string, std::optional<double>> scans;  // mean absolute error by name; none: failed
};

/// Reads the text of an evaluation.json. Throws ReadError when it is none.
Baseline parse_baseline(const std::string& json, const std::string& name_for_messages);

/// What differs: the statistics both have and for which there is a better and a worse, and the
/// scans whose mean absolute error changed by more than 0.0005 cm, most first.
BaselineComparison compare_with(const Baseline& before, const Evaluation& now);

}  // namespace regarment
