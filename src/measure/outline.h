#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// The outer outline of a slice through cloth.
struct Outline {
  std::vector<Vec2> points;  // m, closed, in order, first not repeated; empty: no outline
  double bridged = 0;        // share of its length that runs over gaps without points, 0..1

  double length() const;  // m
};

/// The outer outline of a slice, given as points of its plane (m), folds included: where a tape
/// laid along the cloth lies. Works on outlines that a ray meets several times.
///
/// The curve at distance `reach` round the points that enclose `centre` is followed where it can be
/// reached from outside, which tells the order; each of its vertices is then moved onto the points
/// near it, averaged over a neighbourhood that grows with their scatter, so that noise lengthens
/// the outline no more than smoothing shortens it. Folds narrower than 2 `reach` are not entered.
/// Gaps seen from `centre` wider than `reach` are bridged straight. Where the outside still comes
/// in to the centre, `reach` is widened until it does not. Fewer than 12 points and a curve too
/// open to have an inside give no outline.
Outline trace_outline(const std::vector<Vec2>& points, const Vec2& centre, double reach = 0.006);

/// Length of that outline, m; 0 when there is none. `bridged`, when given, receives its share.
double outline_length(const std::vector<Vec2>& points, const Vec2& centre, double reach = 0.006,
                      double* bridged = nullptr);

}  // namespace regarment
