#include "synthetic/penetration.h"

#include <algorithm>

#include "synthetic/surface_contact.h"

namespace regarment {
namespace {

constexpr double kReach = 0.05;  // m

double depth(const Obstacle& body, const Vec3& p) {
  const ClosestHit hit = body.closest(p, kReach);
  if (!hit.found()) return 0;
  return -body.normal(hit).dot(p - hit.point);
}

}  // namespace

double deepest_inside(const Mesh& body, const std::vector<Triangle>& triangles,
                      const std::vector<Vec3>& positions) {
  const Obstacle obstacle(ObstacleKind::Body, body.triangles, body.positions, 0.0);
  double deepest = 0;
  for (const Triangle& t : triangles) {
    const Vec3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
    for (const Vec3& p :
         {a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2), Vec3((a + b + c) / 3)})
      deepest = std::max(deepest, depth(obstacle, p));
  }
  return deepest;
}

}  // namespace regarment
