#include "measure/cloth_levels.h"

#include <gtest/gtest.h>

#include "support/closed_forms.h"
#include "support/limbs.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;

/// Cloth round the trunk between two edges that may be tilted; edge heights by angle.
struct Cloth {
  test::LimbPlan plan;
  SurfaceSamples samples;
  LimbView view;
  GarmentEdge upper, lower;

  Cloth(const std::function<double(double, double)>& radius,
        const std::function<double(double)>& low, const std::function<double(double)>& high,
        double noise = 0)
      : plan(plan_of(radius, low, high, noise)),
        samples(test::limb_samples(plan, 17)),
        view{test::upright_axis(0.0, 1.6),
             make_limb_map(samples, test::all_of(samples), test::upright_axis(0.0, 1.6), 0.0, 1.5,
                           0.004, 144),
             test::all_of(samples)},
        upper(edge(high, false)),
        lower(edge(low, true)) {}

  static test::LimbPlan plan_of(const std::function<double(double, double)>& radius,
                                const std::function<double(double)>& low,
                                const std::function<double(double)>& high, double noise) {
    test::LimbPlan plan;
    plan.radius = radius, plan.low = 0.4, plan.high = 1.1, plan.spacing = 0.0025;
    plan.missing = [=](double s, double phi) { return s < low(phi) || s > high(phi); };
    plan.noise = noise;
    return plan;
  }
  GarmentEdge edge(const std::function<double(double)>& height, bool garment_above) const {
    GarmentEdge e;
    e.limb = "torso", e.garment_above = garment_above;
    for (int j = 0; j < view.map.columns; ++j) {
      const double phi = view.map.column_phi(j);
      e.found.s.push_back(height(phi));
      e.found.r.push_back(plan.radius(height(phi), phi));
    }
    return e;
  }
};

TEST(ClothLevels, OfACylinderBetweenLevelEdgesAreHeights) {
  const Cloth cloth([](double, double) { return 0.15; }, [](double) { return 0.5; },
                    [](double) { return 1.0; });
  const ClothLevels levels(cloth.view, cloth.upper, &cloth.lower, 0, 0);
  EXPECT_NEAR(levels.length(), 0.5, 1e-3);
  EXPECT_NEAR(levels.level({0.15, 0.8, 0}), 0.2, 1e-3);
  EXPECT_NEAR(levels.height(0.2, 1.0), 0.8, 1e-3);
}

TEST(ClothLevels, OfAConeAreWaysAlongItsSlant) {
  const double slope = 0.4;
  const Cloth cloth([=](double y, double) { return 0.13 + slope * (1.0 - y); },
                    [](double) { return 0.5; }, [](double) { return 1.0; }, 0.0005);
  const ClothLevels whole(cloth.view, cloth.upper, &cloth.lower, 0, 0);
  EXPECT_NEAR(whole.length(), 0.5 * std::hypot(1, slope), 0.004);
  // Without the other edge they are as long as they are.
  const ClothLevels open(cloth.view, cloth.upper, nullptr, 0, 0.3);
  EXPECT_NEAR(open.level({0, 0.8, 0.13 + 0.2 * slope}), 0.2 * std::hypot(1, slope), 0.004);
}

TEST(ClothLevels, GirthsFollowATiltedGarment) {
  // An upright cylinder cut at an angle at both ends: every level is the same ellipse.
  const double r = 0.15, tilt = 0.3;
  const Cloth cloth([=](double, double) { return r; },
                    [=](double phi) { return 0.55 + tilt * r * std::cos(phi); },
                    [=](double phi) { return 0.95 + tilt * r * std::cos(phi); });
  const ClothLevels levels(cloth.view, cloth.upper, &cloth.lower, 0, 0);
  const auto girths = level_girths(cloth.samples, cloth.view.members, cloth.view, levels, 0.02,
                                   0.38, 0.04, 0.004, 0.006);
  ASSERT_EQ(girths.size(), 10U);
  const double expected = test::ellipse_length(r, r * std::hypot(1, tilt));
  ASSERT_GT(expected, 1.02 * test::circle_length(r));
  for (const LevelGirth& g : girths) EXPECT_NEAR(g.girth, expected, 0.005 * expected) << g.t;
}

TEST(ClothLevels, NoiseDoesNotLengthenGirths) {
  const auto folds = [](double, double phi) { return 0.2 + 0.012 * std::cos(9 * phi); };
  const double expected = test::curve_length([&](double t) {
    const double phi = 2 * kPi * t, r = folds(0, phi);
    return Vec2(r * std::cos(phi), r * std::sin(phi));
  });
  for (const double noise : {0.0, 0.0005, 0.001}) {
    const Cloth cloth(
        folds, [](double) { return 0.5; }, [](double) { return 0.7; }, noise);
    const ClothLevels levels(cloth.view, cloth.upper, &cloth.lower, 0, 0);
    for (const LevelGirth& g : level_girths(cloth.samples, cloth.view.members, cloth.view, levels,
                                            0.05, 0.15, 0.05, 0.004, 0.006))
      EXPECT_NEAR(g.girth, expected, 0.012 * expected) << noise;
  }
}

}  // namespace
}  // namespace regarment
