#include "fabric/worn_stretch.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"
#include "tubes.h"

namespace regarment {
namespace {

double flat_girth(const Dimensions& d, double t) {
  if (t < 0.2) return d.at("waist") + t / 0.2 * (d.at("hip") - d.at("waist"));
  return d.at("hip") + (t - 0.2) / (d.at("length") - 0.2) * (d.at("width") - d.at("hip"));
}

// Worn over a tight body: strained by `waist` at the top and `hip` at the hip, each fading over
// 5 cm, loose elsewhere. The pattern knows the worn dimensions only.
std::map<std::string, Stretch> stretch_of(double waist, double hip, Fabric fabric) {
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions flat = test::small_skirt();
  Dimensions worn = flat;
  worn["waist"] *= 1 + waist;
  worn["hip"] *= 1 + hip;
  const Pattern pattern = make_pattern(skirt, worn, 0.015);
  const auto girth = [&](double t) {
    const double strain =
        waist * std::max(0.0, 1 - t / 0.05) + hip * std::max(0.0, 1 - std::abs(t - 0.2) / 0.05);
    return flat_girth(flat, t) * (1 + strain);
  };
  return worn_stretch(skirt, worn, pattern, test::rolled_skirt(pattern, worn, girth),
                      {fabric, 0.002});
}

TEST(WornStretch, FindsATightHipByTheLooseClothBesideIt) {
  const auto out = stretch_of(0.03, 0.04, Fabric::Unknown);
  EXPECT_NEAR(out.at("hip").mean, 0.04, 0.01);
  EXPECT_NEAR(out.at("waist").mean, 0.03, 0.01);
}

TEST(WornStretch, FindsALooseHip) {
  const auto out = stretch_of(0.03, 0, Fabric::Unknown);
  EXPECT_NEAR(out.at("hip").mean, 0, 0.006);
  EXPECT_NEAR(out.at("width").mean, 0, 0.004);
}

TEST(WornStretch, HasEveryDimensionWithAnUncertainty) {
  for (const char* name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    const Pattern pattern = make_pattern(garment, garment.typical(), 0.02);
    std::vector<Vec3> spread;
    for (const Vec2& p : pattern.flat) spread.emplace_back(p.x(), -p.y(), 0);
    const auto out = worn_stretch(garment, garment.typical(), pattern, spread);
    EXPECT_EQ(out.size(), garment.dimensions().size());
    for (const auto& [dimension, stretch] : out) {
      EXPECT_GT(stretch.standard_deviation, 0) << dimension;
      EXPECT_LT(stretch.mean, 0.1) << dimension;
    }
  }
}

TEST(WornStretch, OfAJerseyIsMoreThanOfAWovenWhereNothingIsSeen) {
  EXPECT_GT(stretch_of(0.03, 0, Fabric::Jersey).at("length").mean,
            stretch_of(0.03, 0, Fabric::Woven).at("length").mean);
}

TEST(WornStretch, RefusesWhatIsNoDrape) {
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.03);
  std::vector<Vec3> draped(pattern.flat.size(), Vec3::Zero());
  draped.back().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(worn_stretch(skirt, skirt.typical(), pattern, draped), InvalidInput);
  draped.back().x() = 0;
  EXPECT_THROW(worn_stretch(skirt, skirt.typical(), pattern, draped, {Fabric::Unknown, 0.0}),
               InvalidInput);
  draped.pop_back();
  EXPECT_THROW(worn_stretch(skirt, skirt.typical(), pattern, draped), InvalidInput);
}

}  // namespace
}  // namespace regarment
