#pragma once

#include <string>

#include "report/result.h"

namespace regarment {

/// The text of measurements.csv: layer, template, code, measurement, value_cm, low_cm, high_cm,
/// worn_cm, observable and, when any truth is given, truth_cm and error_cm. One row per dimension,
/// LF line ends; what is not known is an empty cell. Text a spreadsheet would run is made harmless.
std::string measurements_csv(const Result& result);

}  // namespace regarment
