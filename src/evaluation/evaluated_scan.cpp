#include "evaluation/evaluated_scan.h"

#include <cmath>

namespace regarment {

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
