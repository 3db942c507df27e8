#include "drape/contact_force.h"

namespace regarment {
namespace {

// What is farther from the surface is not in contact with it, m.
constexpr double kReach = 0.05;

// What is nearer to contact than this counts in the Jacobian, m: a particle that was pushed out
// would otherwise keep the speed of the push and bounce for ever.
constexpr double kSkin = 0.0005;

/// How far a particle lies too deep, m; negative or zero: no contact.
double depth(const Contact& contact, const Vec3& particle, double thickness) {
  if (contact.normal.isZero(0)) return -kReach;
  return thickness - contact.normal.dot(particle - contact.point);
}

}  // namespace

std::vector<Contact> find_contacts(const Cloth& cloth, const ClosestPoint& scan) {
  ClosestFilter filter;
  filter.max_distance = kReach;
  std::vector<Contact> contacts(cloth.size());
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    const ClosestHit hit = scan.closest(cloth.positions[i], filter);
    if (hit.found()) contacts[i] = {hit.point, hit.normal};
  }
  return contacts;
}

double ContactForce::energy(const Cloth& cloth) const {
  double sum = 0;
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    const double d = depth(contacts[i], cloth.positions[i], thickness);
    if (d > 0) sum += 0.5 * stiffness * d * d;
  }
  return sum;
}

void ContactForce::add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const {
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    const double d = depth(contacts[i], cloth.positions[i], thickness);
    if (d > 0) forces[i] += stiffness * d * contacts[i].normal;
  }
}

void ContactForce::add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const {
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    const Vec3& n = contacts[i].normal;
    if (depth(contacts[i], cloth.positions[i], thickness) > -kSkin)
      jacobian.by_position.add(static_cast<int>(i), -stiffness * n * n.transpose());
  }
}

}  // namespace regarment
