#pragma once

#include <vector>

#include "drape/cloth.h"
#include "drape/force_jacobian.h"

namespace regarment {

/// Resistance to bending between neighbouring triangles [Bridson, Marino and Fedkiw 2003, sec. 4],
/// flat at rest. With the bending modes u_1 ... u_4 and the angle theta between the normals,
///   elastic  k_e |E|^2 / (|N1| + |N2|) sin(theta / 2) u_i
///   damping  -k_d |E| dtheta/dt u_i,   dtheta/dt = sum of u_i · v_i.
/// Their u_i point so that theta, positive where the cloth bulges outwards, falls along them in the
/// elastic and grows in the damping term; here u_i is the gradient of theta in both and the elastic
/// term has the minus. |E| and |N| before the modes are those of the flat cloth, which makes the
/// elastic force the gradient of an energy. An element whose triangle has almost no height has
/// weakened modes, since its own would be without bound.
struct BendingForce {
  double stiffness = 0;  // k_e, N m
  double damping = 0;    // k_d, N s

  /// 2 k_e |E|^2 / (|N1| + |N2|) (1 - cos(theta / 2)) over all elements, J.
  double energy(const Cloth& cloth) const;
  /// Adds to one force per particle, N.
  void add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const;
  /// Exact for flat cloth and for the damping's change with velocity; how the modes turn is left
  /// out, which keeps it negative semidefinite.
  void add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const;
};

}  // namespace regarment
