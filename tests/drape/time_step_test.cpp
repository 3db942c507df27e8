#include "drape/time_step.h"

#include <gtest/gtest.h>

#include "cloths.h"
#include "drape/bending_force.h"
#include "drape/spring_force.h"

namespace regarment {
namespace {

using namespace test;

constexpr double kTolerance = 1e-12;

/// One step under springs, bending and gravity.
void step(Cloth& cloth, const SpringForce& springs, double gravity, double h) {
  std::vector<Vec3> forces;
  for (const double m : cloth.masses) forces.emplace_back(0, -gravity * m, 0);
  ForceJacobian jacobian = make_jacobian(cloth);
  springs.add_forces(cloth, forces);
  springs.add_jacobian(cloth, jacobian);
  TimeStep time_step(cloth);
  advance(cloth, time_step.velocity_change(cloth, forces, jacobian, h, kTolerance), h);
}

TEST(TimeStep, FallsFreely) {
  Cloth cloth = flat_patch(3, 0.06);
  const double h = 0.02, g = 9.81;
  const int steps = 10;
  for (int k = 0; k < steps; ++k) step(cloth, {100, 0.05}, g, h);
  // v_k = -k g h, and x is the sum of h v_k.
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    EXPECT_NEAR(cloth.velocities[i].y(), -steps * g * h, 1e-9);
    EXPECT_NEAR(cloth.positions[i].y(), -g * h * h * steps * (steps + 1) / 2, 1e-9);
  }
}

TEST(TimeStep, SwingsASpringByTheImplicitRecurrence) {
  const double k = 100, d = 0.05, m = 1e-4, rest = 0.02, h = 1e-3;
  Cloth cloth = two_particles(0.021, rest);
  double x = 0.021, v = 0;  // of the distance; both ends move, so the mass is m / 2
  for (int i = 0; i < 20; ++i) {
    step(cloth, {k, d}, 0, h);
    const double f = -k * (x - rest) - d * v;
    v += h * (f - h * k * v) / (m / 2 + h * d + h * h * k);
    x += h * v;
    EXPECT_NEAR(cloth.positions[1].x() - cloth.positions[0].x(), x, 1e-12) << i;
    EXPECT_NEAR(cloth.positions[1].x() + cloth.positions[0].x(), 0.021, 1e-12) << i;
  }
}

TEST(TimeStep, BringsTwoParticlesToRestAtRestLength) {
  for (const double distance : {0.005, 0.03, 0.1}) {
    Cloth cloth = two_particles(distance, 0.02);
    for (int i = 0; i < 100; ++i) step(cloth, {100, 0.05}, 0, 0.02);
    EXPECT_NEAR((cloth.positions[1] - cloth.positions[0]).norm(), 0.02, 1e-9);
    EXPECT_LT((cloth.velocities[1] - cloth.velocities[0]).norm(), 1e-9);
  }
}

TEST(TimeStep, KeepsMomentum) {
  Cloth cloth = flat_patch(4, 0.08);
  shake(cloth, 0.003, 0.2, 11);
  const auto momentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < cloth.size(); ++i) sum += cloth.masses[i] * cloth.velocities[i];
    return sum;
  };
  const Vec3 before = momentum();
  for (int k = 0; k < 20; ++k) step(cloth, {100, 0.05}, 0, 0.02);
  EXPECT_LT((momentum() - before).norm(), 1e-9 * before.norm());
}

TEST(TimeStep, StaysStableWithLongSteps) {
  Cloth cloth = flat_patch(4, 0.08);
  shake(cloth, 0.01, 0, 12);
  const SpringForce springs{100, 0.05};
  const double before = springs.energy(cloth);
  for (int k = 0; k < 50; ++k) step(cloth, springs, 0, 0.25);
  EXPECT_LT(springs.energy(cloth), 1e-3 * before);
}

}  // namespace
}  // namespace regarment
