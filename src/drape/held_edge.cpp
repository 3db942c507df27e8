#include "drape/held_edge.h"

#include "base/error.h"
#include "geometry/closed_curve.h"

namespace regarment {

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
      a.target = closest_on_curve(edge.curve, p).point;
      a.distance = (a.target - p).norm();
      a.found = a.pulls = true;
    }
  }
}

}  // namespace regarment
