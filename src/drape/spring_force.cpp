#include "drape/spring_force.h"

#include <algorithm>

namespace regarment {
namespace {

/// A spring's ends and the vector between them.
struct Span {
  std::size_t a, b;
  Vec3 dx;
  double length;

  Span(const Cloth& cloth, const Spring& spring)
      : a(static_cast<std::size_t>(spring.particle_a)),
        b(static_cast<std::size_t>(spring.particle_b)),
        dx(cloth.positions[b] - cloth.positions[a]),
        length(dx.norm()) {}
};

}  // namespace

double SpringForce::energy(const Cloth& cloth) const {
  double sum = 0;
  for (const Spring& spring : cloth.springs) {
    const double longer = Span(cloth, spring).length - spring.rest_length;
    sum += 0.5 * stiffness * longer * longer;
  }
  return sum;
}

void SpringForce::add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const {
  for (const Spring& spring : cloth.springs) {
    const Span s(cloth, spring);
    if (!(s.length > 0)) continue;
    const Vec3 dv = cloth.velocities[s.b] - cloth.velocities[s.a];
    const Vec3 f = (stiffness * (s.length - spring.rest_length) / s.length +
                    damping * s.dx.dot(dv) / (s.length * s.length)) *
                   s.dx;
    forces[s.a] += f;
    forces[s.b] -= f;
  }
}

void SpringForce::add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const {
  const auto add = [](BlockMatrix& to, const Spring& spring, const Mat3& block) {
    to.add(spring.particle_a, -block);
    to.add(spring.particle_b, -block);
    to.add(spring.particle_a, spring.particle_b, block);
  };
  for (const Spring& spring : cloth.springs) {
    const Span s(cloth, spring);
    if (!(s.length > 0)) continue;
    const Vec3 along = s.dx / s.length;
    const Mat3 outer = along * along.transpose();
    const double sideways = std::max(0.0, 1 - spring.rest_length / s.length);
    add(jacobian.by_position, spring, stiffness * (outer + sideways * (Mat3::Identity() - outer)));
    add(jacobian.by_velocity, spring, damping * outer);
  }
}

}  // namespace regarment
