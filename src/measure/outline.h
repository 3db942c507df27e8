#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Length of the outer outline of a slice, given as points of its plane (m), folds included: what a
/// tape laid along the cloth reads. Works on outlines that a ray meets several times.
///
/// The points are averaged over 4 mm; the curve at distance `reach` round those that enclose
/// `centre` is measured where it can be reached from outside, and 2 pi `reach` is taken off, which
/// is exact for closed curves without hollows narrower than 2 `reach`. Gaps seen from `centre`
/// wider than `reach` are bridged straight. Where the outside still comes in to the centre, `reach`
/// is widened until it does not. `bridged`, when given, receives the share of the length that
/// bridges make up. Returns 0 for fewer than 12 points and for a curve too open to have an inside.
double outline_length(const std::vector<Vec2>& points, const Vec2& centre, double reach = 0.006,
                      double* bridged = nullptr);

}  // namespace regarment
