#include "drape/attraction_force.h"

#include <algorithm>

namespace regarment {
namespace {

/// How the pull changes as the particle moves, over -k_a: fully across the surface; along it as
/// much as the pull itself points along it, since it then goes to an edge or point, not to the
/// surface.
Mat3 change(const Attraction& target, const Vec3& d, double grip) {
  const double squared = d.squaredNorm();
  if (target.normal.isZero(0) || !(squared > 0)) return Mat3::Identity();
  const Vec3& n = target.normal;
  const double along = std::clamp(1 - n.dot(d) * n.dot(d) / squared, 0.0, 1.0);
  const double held = grip + (1 - grip) * along;
  return held * Mat3::Identity() + (1 - held) * n * n.transpose();
}

}  // namespace

double AttractionForce::energy(const Cloth& cloth) const {
  double sum = 0;
  for (std::size_t i = 0; i < cloth.size(); ++i)
    if (targets[i].pulls)
      sum += 0.5 * stiffness * targets[i].weight * targets[i].share *
             (targets[i].target - cloth.positions[i]).squaredNorm();
  return sum;
}

void AttractionForce::add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const {
  for (std::size_t i = 0; i < cloth.size(); ++i)
    if (targets[i].pulls)
      forces[i] += targets[i].weight * targets[i].share * stiffness *
                   (targets[i].target - cloth.positions[i]);
}

void AttractionForce::add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const {
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    if (!targets[i].pulls) continue;
    const Mat3 block = change(targets[i], targets[i].target - cloth.positions[i], grip);
    jacobian.by_position.add(static_cast<int>(i),
                             -targets[i].weight * targets[i].share * stiffness * block);
  }
}

}  // namespace regarment
