#pragma once

#include <vector>

#include "drape/attraction.h"
#include "drape/cloth.h"
#include "drape/force_jacobian.h"

namespace regarment {

/// The pull towards the scan: f_a = k_a d(p, M) on each particle that is pulled
/// [Hasler et al. 2007, sec. 3.2].
struct AttractionForce {
  double stiffness = 0;  // k_a, N/m
  // Share of k_a that the Jacobian has along the surface: 0 exact for a plane, over which cloth
  // slides freely; 1 exact for a point.
  double grip = 0;
  const std::vector<Attraction>& targets;  // one per particle

  /// 1/2 k_a |d|^2 over the pulled particles, J.
  double energy(const Cloth& cloth) const;
  /// Adds to one force per particle, N.
  void add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const;
  /// -k_a across the local surface, little along it.
  void add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const;
};

}  // namespace regarment
