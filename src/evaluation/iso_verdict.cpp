#include "evaluation/iso_verdict.h"

namespace regarment {
namespace {

constexpr double kLargeGirth = 50.0;  // cm; arms and necks stay below, trunks above

}  // namespace

double iso_limit_cm(bool circumference, double mean_truth_cm) {
  if (!circumference) return 0.5;
  return mean_truth_cm >= kLargeGirth ? 0.9 : 0.4;
}

std::optional<IsoVerdict> iso_verdict(const ErrorStatistics& statistics, double limit_cm) {
  if (!statistics.bias_low_cm || !statistics.bias_high_cm) return std::nullopt;
  return IsoVerdict{limit_cm,
                    *statistics.bias_low_cm >= -limit_cm && *statistics.bias_high_cm <= limit_cm};
}

}  // namespace regarment
