#include "report/judgement.h"

namespace regarment {

Tolerance tolerance_of(const ResultMeasurement& m) {
  if (m.tol_minus_cm || m.tol_plus_cm) {
    return {m.tol_minus_cm.value_or(0.0), m.tol_plus_cm.value_or(0.0), true};
  }
  const double usual = m.circumference ? kUsualGirth : kUsualLength;
  return {usual, usual, false};
}

Judgement judge(const ResultMeasurement& m) {
  if (!m.observable) return Judgement::NotMeasurable;
  const std::optional<double> error = m.error_cm();
  if (!error || m.fixed) return Judgement::NotJudged;
  const Tolerance tolerance = tolerance_of(m);
  const double low = m.low_cm - *m.truth_cm, high = m.high_cm - *m.truth_cm;
  if (*error >= -tolerance.minus_cm && *error <= tolerance.plus_cm) {
    const bool inside = low >= -tolerance.minus_cm && high <= tolerance.plus_cm;
    return inside ? Judgement::Pass : Judgement::LikelyPass;
  }
  const bool outside = high < -tolerance.minus_cm || low > tolerance.plus_cm;
  return outside ? Judgement::Fail : Judgement::LikelyFail;
}

}  // namespace regarment
