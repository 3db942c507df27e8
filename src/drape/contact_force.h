#pragma once

#include <vector>

#include "drape/cloth.h"
#include "drape/force_jacobian.h"
#include "geometry/closest_point.h"

namespace regarment {

/// Where a particle is nearest to the scan's surface.
struct Contact {
  Vec3 point = Vec3::Zero();   // of the scan, m
  Vec3 normal = Vec3::Zero();  // outwards there, unit; zero: no contact is possible
};

/// Nearest points within reach for all particles, whatever they face. Points of a cloud without
/// normals make no contact, since they have no outside.
std::vector<Contact> find_contacts(const Cloth& cloth, const ClosestPoint& scan);

/// One-sided contact: a particle nearer to the scan's outer side than the cloth's thickness, or
/// inside, is pushed out along the scan's normal with stiffness times the missing distance.
struct ContactForce {
  double stiffness = 0;                  // N/m
  double thickness = 0;                  // m
  const std::vector<Contact>& contacts;  // one per particle

  /// 1/2 stiffness depth^2 over the particles in contact, J.
  double energy(const Cloth& cloth) const;
  /// Adds to one force per particle, N.
  void add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const;
  /// Exact for a plane, but for particles up to half a millimetre outside of the contact, which it
  /// holds so that they do not bounce.
  void add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const;
};

}  // namespace regarment
