#include "evaluation/evaluated_scan.h"

#include <algorithm>
#include <cmath>

#include "report/judgement.h"

namespace regarment {

bool TrueDimension::tolerates(double error_cm) const {
  ResultMeasurement judged;
  judged.circumference = circumference;
  judged.tol_minus_cm = tol_minus_cm;
  judged.tol_plus_cm = tol_plus_cm;
  const Tolerance allowed = tolerance_of(judged);
  return error_cm >= -allowed.minus_cm && error_cm <= allowed.plus_cm;
}

bool TrueFrame::agrees(const std::string& found_units, const std::string& found_up,
                       const std::string& found_front) const {
  return (units.empty() || units == found_units) && (up.empty() || up == found_up) &&
         (front.empty() || std::find(front.begin(), front.end(), found_front) != front.end());
}

std::optional<double> EvaluatedScan::mean_error_cm() const {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i] || about.dimensions[i].hidden()) continue;
    sum += std::abs(found[i]->value_cm - about.dimensions[i].truth_cm);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

}  // namespace regarment
