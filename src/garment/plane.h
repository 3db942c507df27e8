#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Twice the signed area of the triangle a b c: > 0 when counter-clockwise in (s, t).
inline double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Barycentric coordinates of `p` in the triangle a b c; one is below 0 when it lies outside. Not
/// finite for a triangle without area.
inline Vec3 barycentric(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const double area = twice_area(a, b, c);
  const double of_b = twice_area(a, p, c) / area, of_c = twice_area(a, b, p) / area;
  return {1 - of_b - of_c, of_b, of_c};
}

/// Signed area of a closed polygon, first point not repeated.
double polygon_area(const std::vector<Vec2>& polygon);

/// True when the point lies strictly inside the closed polygon; on the outline either may come out.
bool is_inside(const std::vector<Vec2>& polygon, const Vec2& point);

/// True when the point is nearer to the segment than `tolerance`.
bool is_on_segment(const Vec2& point, const Vec2& a, const Vec2& b, double tolerance);

/// Two segments given as pairs of indices into `points`: true when they meet anywhere but in a
/// shared end point (they cross, overlap, or one's end lies on the other within `tolerance`).
bool segments_clash(const std::vector<Vec2>& points, const std::array<int, 2>& a,
                    const std::array<int, 2>& b, double tolerance);

}  // namespace regarment
