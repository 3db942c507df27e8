#include "garment/plane.h"

#include <algorithm>

namespace regarment {

double polygon_area(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += twice_area(Vec2::Zero(), polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2.0;
}

bool is_inside(const std::vector<Vec2>& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

bool is_on_segment(const Vec2& point, const Vec2& a, const Vec2& b, double tolerance) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double where = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + where * along - point).norm() < tolerance;
}

bool segments_clash(const std::vector<Vec2>& points, const std::array<int, 2>& a,
                    const std::array<int, 2>& b, double tolerance) {
  const auto at = [&](int i) -> const Vec2& { return points[static_cast<std::size_t>(i)]; };
  const auto shared = [](int i, const std::array<int, 2>& s) { return i == s[0] || i == s[1]; };
  if (shared(a[0], b) && shared(a[1], b)) return true;
  for (const int i : a)
    if (!shared(i, b) && is_on_segment(at(i), at(b[0]), at(b[1]), tolerance)) return true;
  for (const int i : b)
    if (!shared(i, a) && is_on_segment(at(i), at(a[0]), at(a[1]), tolerance)) return true;
  if (shared(a[0], b) || shared(a[1], b)) return false;
  const double a0 = twice_area(at(b[0]), at(b[1]), at(a[0]));
  const double a1 = twice_area(at(b[0]), at(b[1]), at(a[1]));
  const double b0 = twice_area(at(a[0]), at(a[1]), at(b[0]));
  const double b1 = twice_area(at(a[0]), at(a[1]), at(b[1]));
  return (a0 > 0.0) != (a1 > 0.0) && (b0 > 0.0) != (b1 > 0.0);
}

}  // namespace regarment
