#include "drape/attraction_force.h"

namespace regarment {
namespace {

// Nearer than this the direction to the target is noise, m; the scan's own normal is taken.
constexpr double kNear = 0.002;

/// Unit vector across the scan's surface at the target; zero when the target has no normal: it is a
/// point then and no surface to slide on.
Vec3 across(const Attraction& target, const Vec3& d) {
  if (target.normal.isZero(0)) return Vec3::Zero();
  return target.distance < kNear ? target.normal : Vec3(d / target.distance);
}

}  // namespace

double AttractionForce::energy(const Cloth& cloth) const {
  double sum = 0;
  for (std::size_t i = 0; i < cloth.size(); ++i)
    if (targets[i].pulls)
      sum += 0.5 * stiffness * targets[i].weight *
             (targets[i].target - cloth.positions[i]).squaredNorm();
  return sum;
}

void AttractionForce::add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const {
  for (std::size_t i = 0; i < cloth.size(); ++i)
    if (targets[i].pulls)
      forces[i] += targets[i].weight * stiffness * (targets[i].target - cloth.positions[i]);
}

void AttractionForce::add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const {
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    if (!targets[i].pulls) continue;
    const Vec3 n = across(targets[i], targets[i].target - cloth.positions[i]);
    const Mat3 block = n.isZero(0) ? Mat3(Mat3::Identity())
                                   : Mat3(grip * Mat3::Identity() + (1 - grip) * n * n.transpose());
    jacobian.by_position.add(static_cast<int>(i), -targets[i].weight * stiffness * block);
  }
}

}  // namespace regarment
