#include "drape/bending_force.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "cloths.h"
#include "differences.h"

namespace regarment {
namespace {

using namespace test;

constexpr double kStiffness = 1e-3, kDamping = 1e-4;
constexpr double kForceError = 1e-8;  // N: energies of 1e-3 J, their rounding over 2e-6 m

/// The angle between the two triangles of a hinge, from their normals alone.
double angle_of(const Cloth& hinge) {
  const auto& x = hinge.positions;
  const Vec3 a = (x[2] - x[0]).cross(x[3] - x[0]).normalized();
  const Vec3 b = (x[3] - x[1]).cross(x[2] - x[1]).normalized();
  const double sign = a.cross(b).dot(x[3] - x[2]) < 0 ? -1 : 1;
  return sign * std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

TEST(BendingForce, IsNothingOnFlatCloth) {
  Cloth cloth = flat_patch(3, 0.06);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& x : cloth.positions) x = turn * x;
  EXPECT_LT(largest(forces_of(BendingForce{kStiffness, kDamping}, cloth),
                    Forces(cloth.size(), Vec3::Zero())),
            1e-15);
}

TEST(BendingForce, FlattensABulge) {
  for (const double angle : {0.4, -0.4}) {
    const Cloth cloth = hinge(angle);
    const Forces f = forces_of(BendingForce{kStiffness, 0}, cloth);
    // The corners of an outward bulge hang down: they are pushed up, the shared side down.
    EXPECT_GT(f[0].y() * angle, 0);
    EXPECT_GT(f[1].y() * angle, 0);
    EXPECT_LT(f[2].y() * angle, 0);
    EXPECT_LT(f[3].y() * angle, 0);
  }
}

TEST(BendingForce, HasThePrintedSize) {
  const double angle = 0.4, h = 0.02;
  const Forces f = forces_of(BendingForce{kStiffness, 0}, hinge(angle));
  // |E|^2 / (|N1| + |N2|) = h^2 / (h^2 + h^2); |u_1| = |E| / |N1| = 1 / h.
  EXPECT_NEAR(f[0].norm(), kStiffness * 0.5 * std::sin(angle / 2) / h, 1e-12);
}

TEST(BendingForce, IsTheSlopeOfItsEnergy) {
  const BendingForce force{kStiffness, 0};
  const auto energy = [&](const Cloth& c) { return force.energy(c); };
  for (const double angle : {0.0, 0.05, -0.05, 1.0, -1.0, 2.5, -2.5}) {
    Cloth cloth = hinge(angle);
    shake(cloth, 0.001, 0, 5);
    EXPECT_LT(largest(forces_of(force, cloth), downhill(energy, cloth)), kForceError) << angle;
  }
  Cloth patch = flat_patch(3, 0.06);
  shake(patch, 0.005, 0, 6);
  EXPECT_LT(largest(forces_of(force, patch), downhill(energy, patch)), kForceError);
}

TEST(BendingForce, KeepsMomentum) {
  Cloth cloth = flat_patch(3, 0.06);
  shake(cloth, 0.005, 0.5, 7);
  const Forces f = forces_of(BendingForce{kStiffness, kDamping}, cloth);
  EXPECT_LT(total(f).norm(), 1e-14);
  EXPECT_LT(torque(cloth, f).norm(), 1e-15);
}

TEST(BendingForce, DampsAsPrinted) {
  Cloth cloth = hinge(0.8);
  shake(cloth, 0.001, 0.3, 8);
  const Forces f = forces_of(BendingForce{0, kDamping}, cloth);
  // -k_d |E| dtheta/dt u_i, the rate and the modes by differences of the angle.
  Cloth later = cloth, earlier = cloth;
  const double dt = 1e-6;
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    later.positions[i] += dt * cloth.velocities[i];
    earlier.positions[i] -= dt * cloth.velocities[i];
  }
  const double rate = (angle_of(later) - angle_of(earlier)) / (2 * dt);
  const Forces minus_u = downhill(angle_of, cloth);
  for (std::size_t i = 0; i < cloth.size(); ++i)
    EXPECT_LT((f[i] - kDamping * 0.02 * rate * minus_u[i]).norm(), 1e-8) << i;
}

TEST(BendingForce, HasItsJacobianWhenFlat) {
  const BendingForce force{kStiffness, kDamping};
  const auto forces = [&](const Cloth& c) { return forces_of(force, c); };
  const Cloth flat = flat_patch(2, 0.04);
  EXPECT_LT(
      (dense(jacobian_of(force, flat).by_position) - numerical_jacobian(forces, flat, By::Position))
          .cwiseAbs()
          .maxCoeff(),
      1e-5);  // N/m, of entries of about 10
  Cloth bent = hinge(1.0);
  shake(bent, 0.001, 0.3, 9);
  EXPECT_LT(
      (dense(jacobian_of(force, bent).by_velocity) - numerical_jacobian(forces, bent, By::Velocity))
          .cwiseAbs()
          .maxCoeff(),
      1e-8);
}

TEST(BendingForce, KeepsStepsSolvableWhenFolded) {
  Cloth cloth = flat_patch(3, 0.06);
  shake(cloth, 0.01, 0.5, 10);
  const ForceJacobian jacobian = jacobian_of(BendingForce{kStiffness, kDamping}, cloth);
  for (const BlockMatrix* m : {&jacobian.by_position, &jacobian.by_velocity}) {
    const Eigen::MatrixXd a = dense(*m);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
    EXPECT_LT(eigen.eigenvalues().maxCoeff(), 1e-12 * a.norm());
  }
}

TEST(BendingForce, StaysFiniteWhereTrianglesCollapse) {
  for (const double height : {0.0, 1e-12, 1e-5}) {
    Cloth cloth = hinge(0.3);
    cloth.positions[0] = Vec3(-height, height, 0);
    cloth.velocities[0] = Vec3(0.1, 0.2, 0.3);
    const BendingForce force{kStiffness, kDamping};
    // N: at most the modes of a triangle a tenth as high as when flat.
    for (const Vec3& f : forces_of(force, cloth)) EXPECT_LT(f.norm(), 1.0) << height;
    EXPECT_TRUE(dense(jacobian_of(force, cloth).by_position).allFinite());
  }
}

}  // namespace
}  // namespace regarment
