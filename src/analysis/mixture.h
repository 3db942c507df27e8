#pragma once

#include <vector>

namespace regarment {

inline constexpr double kNormal90 = 1.645;  // half width of a 90 % interval in deviations

/// One of several things that may be so, and what a length would then be.
struct Outcome {
  double weight = 0;              // > 0
  double mean = 0;                // m
  double standard_deviation = 0;  // m, > 0
};

/// The length below which the share `share` (0..1, exclusive) of a mixture of normal distributions
/// lies, to a micrometre. Throws InvalidInput for no outcomes and for figures out of range.
double mixture_quantile(const std::vector<Outcome>& outcomes, double share);

}  // namespace regarment
