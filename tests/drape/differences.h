#pragma once

#include <functional>
#include <vector>

#include "drape/cloth.h"
#include "drape/force_jacobian.h"

namespace regarment::test {

using Forces = std::vector<Vec3>;

inline constexpr double kDifference = 1e-6;  // m or m/s; central, its error is of the order 1e-12

template <class Force>
Forces forces_of(const Force& force, const Cloth& cloth) {
  Forces forces(cloth.size(), Vec3::Zero());
  force.add_forces(cloth, forces);
  return forces;
}

/// -dE/dx by central differences.
inline Forces downhill(const std::function<double(const Cloth&)>& energy, Cloth cloth) {
  Forces out(cloth.size());
  for (std::size_t i = 0; i < cloth.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      double& x = cloth.positions[i][k];
      const double here = x;
      x = here + kDifference;
      const double more = energy(cloth);
      x = here - kDifference;
      out[i][k] = (energy(cloth) - more) / (2 * kDifference);
      x = here;
    }
  return out;
}

enum class By { Position, Velocity };

/// df/dx or df/dv of all particles, 3n x 3n, by central differences.
inline Eigen::MatrixXd numerical_jacobian(const std::function<Forces(const Cloth&)>& forces,
                                          Cloth cloth, By by) {
  const auto n = static_cast<Eigen::Index>(3 * cloth.size());
  Eigen::MatrixXd out(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    std::vector<Vec3>& state = by == By::Position ? cloth.positions : cloth.velocities;
    double& x = state[static_cast<std::size_t>(j / 3)][j % 3];
    const double here = x;
    x = here + kDifference;
    const Forces more = forces(cloth);
    x = here - kDifference;
    const Forces less = forces(cloth);
    x = here;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto p = static_cast<std::size_t>(i / 3);
      out(i, j) = (more[p][i % 3] - less[p][i % 3]) / (2 * kDifference);
    }
  }
  return out;
}

inline Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  const int n = static_cast<int>(matrix.size());
  Eigen::MatrixXd out(3 * n, 3 * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) out.block<3, 3>(3 * i, 3 * j) = matrix.block(i, j);
  return out;
}

template <class Force>
ForceJacobian jacobian_of(const Force& force, const Cloth& cloth) {
  ForceJacobian jacobian = make_jacobian(cloth);
  force.add_jacobian(cloth, jacobian);
  return jacobian;
}

inline Vec3 total(const Forces& forces) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& f : forces) sum += f;
  return sum;
}

/// Torque of the forces about the origin, N m.
inline Vec3 torque(const Cloth& cloth, const Forces& forces) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < forces.size(); ++i) sum += cloth.positions[i].cross(forces[i]);
  return sum;
}

inline double largest(const Forces& a, const Forces& b) {
  double out = 0;
  for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, (a[i] - b[i]).norm());
  return out;
}

}  // namespace regarment::test
