#include "drape/held_edge.h"

#include <algorithm>

#include "base/error.h"

namespace regarment {
namespace {

Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  if (!(length > 0)) return a;
  return a + std::clamp((p - a).dot(along) / length, 0.0, 1.0) * along;
}

}  // namespace

Vec3 closest_on_curve(const std::vector<Vec3>& curve, const Vec3& p) {
  Vec3 best = curve.front();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec3 q = closest_on_segment(curve[i], curve[(i + 1) % curve.size()], p);
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  }
  return best;
}

void hold(const std::vector<HeldEdge>& edges, const Cloth& cloth,
          std::vector<Attraction>& attraction) {
  for (const HeldEdge& edge : edges) {
    if (edge.curve.empty()) throw InvalidInput("hold: an edge has no curve to be held at");
    for (const int i : edge.particles) {
      if (i < 0 || static_cast<std::size_t>(i) >= cloth.size())
        throw InvalidInput("hold: an edge names particle " + std::to_string(i) +
                           ", the cloth has " + std::to_string(cloth.size()));
      Attraction& a = attraction[static_cast<std::size_t>(i)];
      const Vec3& p = cloth.positions[static_cast<std::size_t>(i)];
      a = {};
      a.target = closest_on_curve(edge.curve, p);
      a.distance = (a.target - p).norm();
      a.found = a.pulls = true;
    }
  }
}

}  // namespace regarment
