#pragma once

#include "report/result.h"

namespace regarment {

/// How far a measured garment may differ from its specification, cm; both >= 0.
struct Tolerance {
  double minus_cm = 0, plus_cm = 0;
  bool given = false;  // by the user; otherwise the usual one of the trade
};

/// The tolerance a dimension is judged by: the one given, where a missing one of the two counts as
/// 0, else the usual one: kUsualLength or, of circumferences, kUsualGirth, either way.
Tolerance tolerance_of(const ResultMeasurement& measurement);

/// A quarter inch of a half measure, so half an inch of the full circumference; lengths as dress
/// makers' spec sheets have them. cm.
inline constexpr double kUsualGirth = 1.3, kUsualLength = 1.0;

enum class Judgement {
  Pass,           // the whole interval lies within the tolerance
  LikelyPass,     // the value does, its interval reaches beyond
  LikelyFail,     // the value lies outside, its interval reaches in
  Fail,           // the whole interval lies outside
  NotMeasurable,  // the scan does not show this dimension
  NotJudged,      // no specification, or a person gave the value
};

/// The dimension against its specification, which is its truth.
Judgement judge(const ResultMeasurement& measurement);

}  // namespace regarment
