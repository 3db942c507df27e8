#include "joint/side_differences.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "joint/joint_system.h"
#include "rolled_skirt.h"

namespace regarment {
namespace {

constexpr double kGirth = 1.0, kLength = 0.6;

JointOptions options() {
  JointOptions options;
  options.levels = {{0.04, 10, 0.02}};
  return options;
}

/// A tube whose hem hangs lower by `left` m at its left than in the middle, by `front` in front.
JointTarget tilted_tube(double left, double front) {
  JointTarget even = tube_target(kGirth, kLength), target = even;
  const double radius = kGirth / (2 * std::numbers::pi);
  // 0 at the waist, 1 at the hem
  const auto down = [](const Vec3& p) { return (1 - p.y()) / kLength; };
  const auto drop = [&](const Vec3& p) { return (left * p.x() + front * p.z()) / radius; };
  for (Vec3& p : target.points) p.y() -= down(p) * drop(p);
  for (Vec3& p : target.edges.at("hem").curve) p.y() -= drop(p);
  return target;
}

std::vector<double> differences(const JointTarget& target) {
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions start = tube_dimensions(kGirth, kLength);
  const Pattern pattern = make_pattern(skirt, start, 0.05);
  const JointFit fit =
      joint_fit(skirt, start, pattern, rolled(pattern, kGirth, kGirth / (2 * std::numbers::pi)),
                target, {}, options(), {});
  return side_differences(skirt, fit, target, {},
                          {{"length", Sides::LeftRight}, {"length", Sides::FrontBack}}, options());
}

TEST(SideDifferences, AreNoneOfAnEvenTube) {
  const std::vector<double> even = differences(tilted_tube(0, 0));
  ASSERT_EQ(even.size(), 2U);
  EXPECT_NEAR(even[0], 0, 0.001);
  EXPECT_NEAR(even[1], 0, 0.001);
}

// A hem that is 1 cm lower on the left and 1 cm higher on the right.
TEST(SideDifferences, FindATiltedHem) {
  const std::vector<double> left = differences(tilted_tube(0.01, 0));
  EXPECT_NEAR(left[0], 0.02, 0.005);
  EXPECT_NEAR(left[1], 0, 0.002);
  const std::vector<double> front = differences(tilted_tube(0, 0.01));
  EXPECT_NEAR(front[0], 0, 0.002);
  EXPECT_NEAR(front[1], 0.02, 0.005);
}

TEST(SideDifferences, TurnTheirSignWithTheSides) {
  const std::vector<double> left = differences(tilted_tube(0.01, 0)),
                            right = differences(tilted_tube(-0.01, 0));
  EXPECT_NEAR(left[0], -right[0], 5e-4);  // m, the mesh is not quite its own mirror image
}

TEST(SideDifferences, OfAnUnknownDimensionAreRefused) {
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.06);
  EXPECT_THROW(sided_slope(flat_slopes(skirt, skirt.typical(), pattern), pattern, {"brim"}),
               InvalidInput);
}

// The slope of the added dimension, against the energy's own differences.
TEST(SideDifferences, GradientIsThatOfTheEnergy) {
  const GarmentTemplate skirt = find_template("skirt");
  JointModel model(skirt, tube_dimensions(kGirth, kLength), 0.06, JointScales{});
  FlatSlopes extra;
  extra.names = {"tilt"};
  extra.vertex = {sided_slope(model.flat(), model.pattern(), {"length", Sides::LeftRight})};
  model.add_slopes(extra, 0.1);
  const std::vector<Vec3> x = particles_of(model.pattern(), rolled(model.pattern(), kGirth, 0.165));
  match_scan(tilted_tube(0.01, 0), x, {}, model);
  Eigen::VectorXd there = Eigen::VectorXd::Zero(5);
  there[4] = 0.01;
  model.shift(there);
  const Eigen::VectorXd gradient = model.dimension_gradient(x);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 5; ++k) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(5);
    step[k] = kStep;
    const double slope = (model.energy(x, step) - model.energy(x, -step)) / (2 * kStep);
    EXPECT_NEAR(gradient[k], slope, 1e-4 * gradient.norm()) << k;
  }
}

}  // namespace
}  // namespace regarment
