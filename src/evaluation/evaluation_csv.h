#pragma once

#include <string>

#include "evaluation/evaluation.h"

namespace regarment {

/// evaluation.csv: one row per scan and dimension with the columns scan, file, kind, damage, layer,
/// template, measurement, truth_cm, estimate_cm, low_cm, high_cm, error_cm, observable,
/// truth_observable, worn_cm, worn_truth_cm, published_cm, failure. LF line ends; what is not known
/// is an empty cell. `--estimates` reads it back.
std::string evaluation_csv(const Evaluation& evaluation);

}  // namespace regarment
