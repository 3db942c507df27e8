#include "fabric/hoop_bands.h"

#include <gtest/gtest.h>

#include "tubes.h"

namespace regarment {
namespace {

HoopFamily skirt_bands(const Dimensions& flat, const std::function<double(double)>& girth) {
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, flat, 0.015);
  const std::vector<HoopFamily> families =
      hoop_families(skirt, flat, pattern, test::rolled_skirt(pattern, flat, girth),
                    {"width", "waist", "hip"}, {});
  EXPECT_EQ(families.size(), 1U);  // all three lines run alike
  return families.front();
}

double flat_girth(const Dimensions& d, double t) {
  if (t < 0.2) return d.at("waist") + t / 0.2 * (d.at("hip") - d.at("waist"));
  return d.at("hip") + (t - 0.2) / (d.at("length") - 0.2) * (d.at("width") - d.at("hip"));
}

TEST(HoopBands, SeeNoStrainInARolledPattern) {
  const Dimensions flat = test::small_skirt();
  const HoopFamily family = skirt_bands(flat, [&](double t) { return flat_girth(flat, t); });
  ASSERT_GT(family.bands.size(), 20U);
  for (const HoopBand& band : family.bands) EXPECT_NEAR(band.excess, 0, 0.002) << band.position;
}

TEST(HoopBands, SeeAStripThatIsStretched) {
  const Dimensions flat = test::small_skirt();
  // 4 % round the depth of 10 cm, as far as 6 cm beside it.
  const auto strain = [](double t) { return 0.04 * std::max(0.0, 1 - std::abs(t - 0.1) / 0.06); };
  const HoopFamily family =
      skirt_bands(flat, [&](double t) { return flat_girth(flat, t) * (1 + strain(t)); });
  const double top = family.bands.front().position;
  for (const HoopBand& band : family.bands) {
    // A strip reaches 2 cm up and down; the tip of the strain is rounded off by that.
    EXPECT_NEAR(band.excess, strain(band.position - top), 0.007) << band.position - top;
  }
}

TEST(HoopBands, ShareTheirLengthAmongTheDimensionsLinearly) {
  const Dimensions flat = test::small_skirt();
  const HoopFamily family = skirt_bands(flat, [&](double t) { return flat_girth(flat, t); });
  ASSERT_EQ(family.dimensions, (std::vector<std::string>{"width", "waist", "hip"}));
  const double top = family.bands.front().position;
  for (const HoopBand& band : family.bands) {
    const double t = band.position - top;
    if (t < 0.02 || t > 0.48 || std::abs(t - 0.2) < 0.03) continue;  // half strips and the kink
    const double up = std::max(0.0, 1 - t / 0.2), down = std::max(0.0, (t - 0.2) / 0.3);
    const double girth = flat_girth(flat, t);
    EXPECT_NEAR(band.share[0], down * flat.at("width") / girth, 0.03);
    EXPECT_NEAR(band.share[1], up * flat.at("waist") / girth, 0.03);
    EXPECT_NEAR(band.share[2], (1 - up - down) * flat.at("hip") / girth, 0.03);
  }
}

TEST(HoopBands, SeeFolds) {
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions flat = test::small_skirt();
  const Pattern pattern = make_pattern(skirt, flat, 0.015);
  std::vector<Vec3> smooth =
      test::rolled_skirt(pattern, flat, [&](double t) { return flat_girth(flat, t); });
  std::vector<Vec3> folded = smooth;
  for (Vec3& p : folded) {
    // Eight folds 3 cm deep: the tape goes from ridge to ridge.
    const double scale = 1 + 0.1 * std::cos(8 * std::atan2(p.x(), p.z()));
    p = Vec3(scale * p.x(), p.y(), scale * p.z());
  }
  const std::vector<std::string> names = {"width", "waist", "hip"};
  const HoopFamily round = hoop_families(skirt, flat, pattern, smooth, names, {}).front();
  const HoopFamily wavy = hoop_families(skirt, flat, pattern, folded, names, {}).front();
  for (const HoopBand& band : round.bands) EXPECT_LT(band.fold, 0.002);
  // r = 1 + 0.1 cos 8a is 7.194 long, its hull 6.762 (numerical integration); chords of 1.5 cm lose
  // some of either.
  const double expected = std::log(7.194 / 6.762);
  for (const HoopBand& band : wavy.bands) EXPECT_NEAR(band.fold, expected, 0.01);
  ASSERT_EQ(wavy.folds.size(), 3U);
  for (const double fold : wavy.folds) EXPECT_NEAR(fold, expected, 0.01);
}

TEST(HoopBands, OfAShirtEndBelowTheArms) {
  const GarmentTemplate shirt = find_template("tshirt");
  const Dimensions flat = shirt.typical();
  const Pattern pattern = make_pattern(shirt, flat, 0.02);
  std::vector<Vec3> spread;
  for (const Vec2& p : pattern.flat) spread.emplace_back(p.x(), -p.y(), 0);
  const std::vector<HoopFamily> families =
      hoop_families(shirt, flat, pattern, spread, {"width", "sleeve_opening"}, {"sleeve_seam"});
  ASSERT_EQ(families.size(), 2U);
  const double underarm = 0.025;  // m: the width's line is drawn so far below it
  for (const HoopBand& band : families[0].bands) EXPECT_GT(band.position, -underarm - 0.02);
  EXPECT_GE(families[0].bands.size(), 22U);  // of 48 cm from underarm to hem
  for (const HoopBand& band : families[0].bands) EXPECT_NEAR(band.share[0], 1, 1e-6);
}

}  // namespace
}  // namespace regarment
