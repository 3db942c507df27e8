#include <gtest/gtest.h>

#include <numbers>

#include "base/error.h"
#include "placement/limb_map.h"
#include "support/dice.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;

double turn_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

void expect_inverse(const LimbAxis& axis, double s_low, double s_high, double r_high,
                    double tolerance, std::uint64_t seed) {
  test::Dice dice(seed);
  for (int k = 0; k < 2000; ++k) {
    const LimbPoint p{dice.uniform(s_low, s_high), dice.uniform(-kPi, kPi),
                      dice.uniform(0.02, r_high)};
    const LimbPoint q = axis.locate(axis.point(p));
    ASSERT_NEAR(q.s, p.s, tolerance) << "s " << p.s << " phi " << p.phi << " r " << p.r;
    ASSERT_NEAR(q.r, p.r, tolerance);
    ASSERT_LT(turn_between(q.phi, p.phi) * p.r, tolerance);
    ASSERT_LT((axis.point(q) - axis.point(p)).norm(), tolerance);
  }
}

/// A body whose trunk leans and sways, straight as far as the axis can tell.
Body swaying_body() {
  Body body;
  body.height = 1.7;
  for (int i = 0; i < 150; ++i) {
    TrunkLevel level;
    level.y = (i + 0.5) * 0.01;
    const double x = 0.05 * std::sin(2 * level.y), z = 0.04 * level.y;
    level.x_min = x - 0.15, level.x_max = x + 0.15, level.z_min = z - 0.1, level.z_max = z + 0.1;
    level.present = i % 7 != 3;  // some levels are missing
    body.trunk.push_back(level);
  }
  return body;
}

TEST(LimbAxis, TrunkPointAndLocateAreInverse) {
  expect_inverse(trunk_axis(swaying_body()), 0.0, 1.5, 0.4, 1e-9, 1);
}

TEST(LimbAxis, TrunkMeasuresHeightAndTurnsFromTheFrontToTheLeft) {
  const LimbAxis axis = trunk_axis(swaying_body());
  EXPECT_NEAR(axis.point({0.7, 0, 0.2}).y(), 0.7, 1e-12);
  const Vec3 middle = axis.point({0.7, 0, 0});
  EXPECT_LT((axis.point({0.7, 0, 0.2}) - middle - Vec3(0, 0, 0.2)).norm(), 1e-12);
  EXPECT_LT((axis.point({0.7, kPi / 2, 0.2}) - middle - Vec3(0.2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((axis.radial(0.7, kPi / 2) - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((axis.tangent(0.7) - Vec3::UnitY()).norm(), 1e-12);
}

TEST(LimbAxis, StraightArmPointAndLocateAreInverseAlsoBeyondItsEnds) {
  Body body;
  const Vec3 from(0.1, 1.3, 0.02), along = Vec3(1, -1, 0.1).normalized();
  for (int i = 0; i < 20; ++i) body.arms[0].points.push_back(from + 0.03 * i * along);
  const LimbAxis axis = arm_axis(body, 0);
  EXPECT_NEAR(axis.s_min(), -body.arm_axis_lead, 1e-12);
  EXPECT_NEAR(axis.s_max(), 19 * 0.03 - body.arm_axis_lead, 1e-9);
  expect_inverse(axis, -0.25, 0.7, 0.12, 1e-9, 2);
}

TEST(LimbAxis, BentArmPointAndLocateAreInverseWithinTheBendOfItsJoints) {
  // Joints of 4 degrees every 3 cm: rays lean by at most half of that against their segment.
  const double joint = 4 * kPi / 180;
  Body body;
  Vec3 p(0.1, 1.3, 0);
  double angle = 0.3;
  for (int i = 0; i < 15; ++i) {
    body.arms[1].points.push_back(p);
    p += 0.03 * Vec3(-std::sin(angle), -std::cos(angle), 0);
    angle += joint;
  }
  expect_inverse(arm_axis(body, 1), -0.1, 0.2, 0.06, 0.06 * std::sin(joint), 3);
}

TEST(LimbAxis, ArmTurnsFromItsUpperSideToTheFrontOnTheLeftAndToTheBackOnTheRight) {
  Body body;
  for (int i = 0; i < 10; ++i) {
    body.arms[0].points.emplace_back(0.1 + 0.05 * i, 1.3, 0);
    body.arms[1].points.emplace_back(-0.1 - 0.05 * i, 1.3, 0);
  }
  for (int side = 0; side < 2; ++side) {
    const LimbAxis axis = arm_axis(body, side);
    EXPECT_LT((axis.radial(0.1, 0) - Vec3::UnitY()).norm(), 1e-12);
    const Vec3 quarter = side == 0 ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ());
    EXPECT_LT((axis.radial(0.1, kPi / 2) - quarter).norm(), 1e-12) << "side " << side;
  }
}

TEST(LimbAxis, PolarPointAndLocateAreInverse) {
  expect_inverse(LimbAxis::polar({0.02, 1.3, -0.01}), 0.005, 0.15 * kPi - 0.005, 0.5, 1e-9, 4);
}

TEST(LimbAxis, PolarRaysStartStraightUpAndTurnFromTheFrontToTheLeft) {
  const Vec3 centre(0.02, 1.3, -0.01);
  const LimbAxis axis = LimbAxis::polar(centre);
  EXPECT_LT((axis.point({0, 1.0, 0.3}) - centre - Vec3(0, 0.3, 0)).norm(), 1e-12);
  EXPECT_LT((axis.point({0.15 * kPi / 2, 0, 0.3}) - centre - Vec3(0, 0, 0.3)).norm(), 1e-12);
  EXPECT_LT((axis.point({0.15 * kPi / 2, kPi / 2, 0.3}) - centre - Vec3(0.3, 0, 0)).norm(), 1e-12);
}

TEST(LimbAxis, RefusesWhatIsNoLine) {
  EXPECT_THROW(LimbAxis({Vec3::Zero()}, {0.0}, Vec3::UnitZ()), InvalidInput);
  EXPECT_THROW(LimbAxis({Vec3::Zero(), Vec3::UnitY()}, {0.0}, Vec3::UnitZ()), InvalidInput);
}

}  // namespace
}  // namespace regarment
