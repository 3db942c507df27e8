#pragma once

#include <vector>

#include "drape/cloth.h"
#include "drape/force_jacobian.h"

namespace regarment {

/// The damped springs of the cloth, for each spring with dx = x_b - x_a and dv = v_b - v_a
///   f = ±(k_s (|dx| - l0)/|dx| + k_d (dx·dv)/|dx|^2) dx   [Hasler et al. 2007, sec. 3.2],
/// plus on a, minus on b. Two particles at one point have no direction: no force.
struct SpringForce {
  double stiffness = 0;  // k_s, N/m
  double damping = 0;    // k_d, N s/m

  /// 1/2 k_s (|dx| - l0)^2 over all springs, J.
  double energy(const Cloth& cloth) const;
  /// Adds to one force per particle, N.
  void add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const;
  /// Exact for springs at rest length or longer, but for the change of the damping with position;
  /// a compressed spring's push sideways, which would make the step unstable, is left out.
  void add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const;
};

}  // namespace regarment
