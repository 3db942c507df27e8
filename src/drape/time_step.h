#pragma once

#include <vector>

#include "drape/cloth.h"
#include "drape/conjugate_gradient.h"
#include "drape/force_jacobian.h"

namespace regarment {

/// The semi-implicit step of Baraff and Witkin 1998, Eq. (6): the velocities change by dv with
///   (M - h df/dv - h^2 df/dx) dv = h (f + h df/dx v),
/// then the positions by h (v + dv). Made for one cloth's topology; one thread at a time.
class TimeStep {
 public:
  explicit TimeStep(const Cloth& cloth);

  /// dv for a step of h seconds, one per particle, m/s. `tolerance` of the linear solve.
  const std::vector<Vec3>& velocity_change(const Cloth& cloth, const std::vector<Vec3>& forces,
                                           const ForceJacobian& jacobian, double h,
                                           double tolerance);

  int solver_iterations() const { return iterations_; }  // of the last step

 private:
  BlockMatrix system_;
  ConjugateGradient solver_;
  std::vector<Vec3> right_, change_;
  int iterations_ = 0;
};

/// Moves the cloth by a step: v += dv, x += h v.
void advance(Cloth& cloth, const std::vector<Vec3>& velocity_change, double h);

}  // namespace regarment
