#include "drape/spring_force.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "cloths.h"
#include "differences.h"

namespace regarment {
namespace {

using namespace test;

constexpr double kStiffness = 100, kDamping = 0.05;
constexpr double kForceError = 1e-7;  // N: energies of 1e-2 J, their rounding over 2e-6 m

TEST(SpringForce, PullsTogetherWhenLongerThanRest) {
  const Forces f = forces_of(SpringForce{kStiffness, 0}, two_particles(0.03, 0.02));
  EXPECT_NEAR(f[0].x(), 100 * 0.01, 1e-12);
  EXPECT_NEAR(f[1].x(), -100 * 0.01, 1e-12);
}

TEST(SpringForce, PushesApartWhenShorterThanRest) {
  const Forces f = forces_of(SpringForce{kStiffness, 0}, two_particles(0.015, 0.02));
  EXPECT_NEAR(f[0].x(), -100 * 0.005, 1e-12);
}

TEST(SpringForce, IsNothingAtRest) {
  EXPECT_EQ(total(forces_of(SpringForce{kStiffness, kDamping}, two_particles(0.02, 0.02))),
            Vec3::Zero());
}

TEST(SpringForce, DampsAsPrinted) {
  Cloth cloth = two_particles(0.02, 0.02);
  cloth.positions[1] = Vec3(0.012, 0.016, 0);  // 2 cm away, along (0.6, 0.8)
  cloth.velocities[0] = Vec3(0.1, 0, 0);
  cloth.velocities[1] = Vec3(0.4, 0.5, 0.7);
  const Forces f = forces_of(SpringForce{kStiffness, kDamping}, cloth);
  // dx·dv = 0.012 * 0.3 + 0.016 * 0.5 = 0.0116; k_d times it over |dx|^2 = 4e-4, times dx.
  const Vec3 expected = 0.05 * 0.0116 / 4e-4 * Vec3(0.012, 0.016, 0);
  EXPECT_LT((f[0] - expected).norm(), 1e-12);
  EXPECT_LT((f[1] + expected).norm(), 1e-12);
}

TEST(SpringForce, IsTheSlopeOfItsEnergy) {
  Cloth cloth = flat_patch(3, 0.06);
  shake(cloth, 0.005, 0, 1);
  const SpringForce force{kStiffness, 0};
  EXPECT_LT(largest(forces_of(force, cloth),
                    downhill([&](const Cloth& c) { return force.energy(c); }, cloth)),
            kForceError);
}

TEST(SpringForce, KeepsMomentum) {
  Cloth cloth = flat_patch(3, 0.06);
  shake(cloth, 0.005, 0.5, 2);
  const Forces f = forces_of(SpringForce{kStiffness, kDamping}, cloth);
  EXPECT_LT(total(f).norm(), 1e-13);
  EXPECT_LT(torque(cloth, f).norm(), 1e-14);
}

TEST(SpringForce, HasItsJacobianWhenStretched) {
  Cloth cloth = flat_patch(3, 0.06);
  shake(cloth, 0.002, 0.5, 3);
  for (Vec3& x : cloth.positions) x *= 1.5;  // all springs longer than at rest
  const SpringForce elastic{kStiffness, 0}, damped{0, kDamping};
  const auto of = [](const SpringForce& f) {
    return [&f](const Cloth& c) { return forces_of(f, c); };
  };
  // N/m: stiffness of 100 by second differences of a smooth force.
  EXPECT_LT((dense(jacobian_of(elastic, cloth).by_position) -
             numerical_jacobian(of(elastic), cloth, By::Position))
                .cwiseAbs()
                .maxCoeff(),
            1e-4);
  EXPECT_LT((dense(jacobian_of(damped, cloth).by_velocity) -
             numerical_jacobian(of(damped), cloth, By::Velocity))
                .cwiseAbs()
                .maxCoeff(),
            1e-8);
}

TEST(SpringForce, KeepsStepsSolvableWhenCompressed) {
  Cloth cloth = flat_patch(3, 0.06);
  shake(cloth, 0.002, 0.5, 4);
  for (Vec3& x : cloth.positions) x *= 0.5;
  const ForceJacobian jacobian = jacobian_of(SpringForce{kStiffness, kDamping}, cloth);
  for (const BlockMatrix* m : {&jacobian.by_position, &jacobian.by_velocity}) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense(*m));
    EXPECT_LT(eigen.eigenvalues().maxCoeff(), 1e-10);  // rounding of blocks of 100
  }
}

TEST(SpringForce, IsNothingBetweenParticlesAtOnePoint) {
  const Cloth cloth = two_particles(0, 0.02);
  const SpringForce force{kStiffness, kDamping};
  EXPECT_EQ(forces_of(force, cloth)[0], Vec3::Zero());
  EXPECT_EQ(dense(jacobian_of(force, cloth).by_position).norm(), 0);
}

}  // namespace
}  // namespace regarment
