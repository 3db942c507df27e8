#include "fabric/free_girth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tubes.h"

namespace regarment {
namespace {

// A T-shirt whose body is a tube with eight folds, `girth(way)` round where `way` of it, 0 at the
// underarm to 1 at the hem, has been gone. `fold`: the depth of folds as a share of the radius.
std::map<std::string, FreeGirth> girths_of(double fold,
                                           const std::function<double(double)>& girth) {
  const GarmentTemplate garment = find_template("tshirt");
  const Dimensions flat = garment.typical();
  const Pattern pattern = make_pattern(garment, flat, 0.01);
  const double underarm = 0.27, hem = flat.at("length");
  // The length of r = 1 + fold cos 8a, by the trapezoid rule.
  double round = 0;
  for (int i = 0; i < 1000; ++i) {
    const double a = 2 * std::numbers::pi * i / 1000;
    round += std::hypot(1 + fold * std::cos(8 * a), 8 * fold * std::sin(8 * a)) / 1000;
  }
  std::vector<Vec3> worn;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const auto panel = static_cast<std::size_t>(pattern.panel[v]);
    const Vec2 at = pattern.flat[v];
    if (pattern.panel_limbs[panel] != "torso") {
      worn.emplace_back(at.x(), 1 - at.y(), 0);
      continue;
    }
    const double way = std::clamp((at.y() - underarm) / (hem - underarm), 0.0, 1.0);
    const double turn = at.x() / (flat.at("width") / 4) * std::numbers::pi / 2;
    const double radius =
        girth(way) / (2 * std::numbers::pi * round) * (1 + fold * std::cos(8 * turn));
    const double ahead = radius * std::cos(turn);
    worn.emplace_back(radius * std::sin(turn), 1 - at.y(),
                      pattern.panel_is_front[panel] ? ahead : -ahead);
  }
  return free_girths(garment, flat, pattern, worn);
}

TEST(FreeGirth, IsReadWhereTheClothHangs) {
  // Five centimetres are missing at the underarm, none in the lower half.
  const auto girth = [](double way) { return 1.02 - 0.05 * std::max(0.0, 1 - 2 * way); };
  const auto out = girths_of(0.1, girth);
  ASSERT_TRUE(out.contains("width"));
  EXPECT_NEAR(out.at("width").length, 1.02, 0.01);
  EXPECT_GT(out.at("width").loose, 0.8);
}

TEST(FreeGirth, OfSmoothClothMayBeStretched) {
  const auto out = girths_of(0, [](double) { return 1.06; });
  ASSERT_TRUE(out.contains("width"));
  EXPECT_NEAR(out.at("width").length, 1.06, 0.006);
  EXPECT_LT(out.at("width").loose, 0.3);
}

TEST(FreeGirth, NeedsStraightSides) {
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions flat = test::small_skirt();
  const Pattern pattern = make_pattern(skirt, flat, 0.015);
  const auto worn = test::rolled_skirt(pattern, flat, [](double) { return 1.0; });
  EXPECT_TRUE(free_girths(skirt, flat, pattern, worn).empty());
}

TEST(FreeGirth, TakesTheStretchAwayWhereItIsLoose) {
  const Stretch here{0.03, 0.01};
  EXPECT_DOUBLE_EQ(where_free(here, {1, 0}).mean, here.mean);
  EXPECT_LT(where_free(here, {1, 1}).mean, 0.005);
  EXPECT_DOUBLE_EQ(where_free(here, {1, 1}).standard_deviation, here.standard_deviation);
}

}  // namespace
}  // namespace regarment
