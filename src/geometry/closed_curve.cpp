#include "geometry/closed_curve.h"

#include <algorithm>
#include <limits>

namespace regarment {

CurvePoint closest_on_curve(const std::vector<Vec3>& curve, const Vec3& p) {
  CurvePoint best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec3& from = curve[i];
    const Vec3 along = curve[(i + 1) % curve.size()] - from;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((p - from).dot(along) / length, 0.0, 1.0) : 0.0;
    const Vec3 here = from + share * along;
    if ((here - p).squaredNorm() >= least) continue;
    least = (here - p).squaredNorm();
    best = {here, along, i, share};
  }
  return best;
}

}  // namespace regarment
