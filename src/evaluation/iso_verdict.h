#pragma once

#include <optional>

#include "evaluation/statistics.h"

namespace regarment {

/// ISO 20685 asks that the 95 % confidence interval of the mean error lie within a limit. Its
/// limits are those of body dimensions; a garment's are held to those of the body dimensions they
/// follow.
struct IsoVerdict {
  double limit_cm = 0;
  bool within = false;
};

/// The limit for a dimension: 0.9 cm for large girths (circumferences of 50 cm and more: waist,
/// hip, chest, hem), 0.4 cm for smaller ones (a sleeve's), 0.5 cm for lengths along the body.
double iso_limit_cm(bool circumference, double mean_truth_cm);

/// Nothing where there is no confidence interval.
std::optional<IsoVerdict> iso_verdict(const ErrorStatistics& statistics, double limit_cm);

}  // namespace regarment
