#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "measure/edge_finder.h"
#include "support/closed_forms.h"
#include "support/dice.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Vec3> ellipse(double a, double b, int points) {
  // In a plane that is none of the coordinate planes.
  const Vec3 u = Vec3(1, 2, -1).normalized(), v = u.unitOrthogonal();
  std::vector<Vec3> curve;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * kPi * k / points;
    curve.push_back(Vec3(0.1, 1.0, -0.2) + a * std::cos(angle) * u + b * std::sin(angle) * v);
  }
  return curve;
}

TEST(ClosedLength, OfARegularPolygonIsExact) {
  // The mean of 2 h + 1 neighbours of a regular polygon is a regular polygon, smaller by the mean
  // of the cosines between them.
  for (const int n : {12, 40, 144})
    for (const int half : {0, 1, 3}) {
      double shrink = 1;
      for (int k = 1; k <= half; ++k) shrink += 2 * std::cos(2 * kPi * k / n);
      shrink /= 2 * half + 1;
      const double expected = 2 * n * 0.2 * shrink * std::sin(kPi / n);
      EXPECT_NEAR(closed_length(ellipse(0.2, 0.2, n), half), expected, 1e-12) << n << ", " << half;
    }
}

TEST(ClosedLength, OfCirclesAndEllipsesIsTheirPerimeter) {
  for (const double a : {0.05, 0.12, 0.3})
    for (const double ratio : {1.0, 0.7, 0.4}) {
      const double expected = test::ellipse_length(a, ratio * a);
      EXPECT_NEAR(closed_length(ellipse(a, ratio * a, 144)), expected, 2e-3 * expected)
          << a << ", " << ratio;
    }
}

TEST(ClosedLength, TheSeriesForEllipsesIsRight) {
  for (const double b : {0.3, 0.2, 0.1}) {
    const double direct = test::curve_length(
        [&](double t) { return Vec2(0.3 * std::cos(2 * kPi * t), b * std::sin(2 * kPi * t)); });
    EXPECT_NEAR(test::ellipse_length(0.3, b), direct, 1e-8);
  }
}

TEST(ClosedLength, SmoothingTakesMostOfTheNoiseAway) {
  test::Dice dice(5);
  std::vector<Vec3> curve = ellipse(0.16, 0.16, 144);
  for (Vec3& p : curve) p += Vec3(dice.normal(0.001), dice.normal(0.001), dice.normal(0.001));
  const double truth = test::circle_length(0.16);
  EXPECT_GT(closed_length(curve, 0), 1.015 * truth);
  EXPECT_NEAR(closed_length(curve, 2), truth, 0.01 * truth);
}

}  // namespace
}  // namespace regarment
