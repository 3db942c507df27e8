#include "render/heat_map.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

double linear_channel(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// CIE L*a*b* under D65, straight from the definition.
Vec3 lab_from_linear(const Vec3& rgb) {
  Eigen::Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339,
      0.1191920, 0.9503041;
  const Vec3 xyz = (xyz_from_rgb * rgb).cwiseQuotient(Vec3(0.95047, 1.0, 1.08883));
  const auto f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  const Vec3 g(f(xyz.x()), f(xyz.y()), f(xyz.z()));
  return {116.0 * g.y() - 16.0, 500.0 * (g.x() - g.y()), 200.0 * (g.y() - g.z())};
}

Vec3 linear_from(Colour c) {
  return {linear_channel(c[0]), linear_channel(c[1]), linear_channel(c[2])};
}

double lightness(Colour c) { return lab_from_linear(linear_from(c)).x(); }

constexpr double kRounding = 0.7;  // L*, of colours rounded to eight bits and to what sRGB can show

TEST(Palette, ViridisGrowsLighterAllTheWay) {
  for (int i = 0; i < 64; ++i) {
    EXPECT_LT(lightness(palette_colour(Palette::Viridis, i / 64.0)),
              lightness(palette_colour(Palette::Viridis, (i + 1) / 64.0)))
        << i;
  }
}

TEST(Palette, DivergingIsLightestInTheMiddleAndEvenOnBothSides) {
  for (int i = 0; i <= 32; ++i) {
    const double low = lightness(palette_colour(Palette::Diverging, i / 64.0));
    const double high = lightness(palette_colour(Palette::Diverging, 1.0 - i / 64.0));
    EXPECT_NEAR(low, high, kRounding) << i;
    if (i == 0) continue;
    EXPECT_GT(low, lightness(palette_colour(Palette::Diverging, (i - 1) / 64.0)));
  }
}

TEST(Palette, StepsAreEvenInLightness) {
  for (const Palette palette : {Palette::Viridis, Palette::Diverging}) {
    const double half = palette == Palette::Diverging ? 0.5 : 1.0;
    const double first = lightness(palette_colour(palette, 0.0));
    const double last = lightness(palette_colour(palette, half));
    for (int i = 1; i < 16; ++i) {
      const double even = first + (last - first) * i / 16.0;
      EXPECT_NEAR(lightness(palette_colour(palette, half * i / 16.0)), even, 2.5) << i;
    }
  }
}

TEST(Palette, MiddleOfDivergingIsNeutral) {
  const Colour c = palette_colour(Palette::Diverging, 0.5);
  EXPECT_LE(std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]}), 2);
}

TEST(Palette, NoDataIsGreyAndValuesOutsideAreClamped) {
  EXPECT_EQ(palette_colour(Palette::Viridis, std::nan("")), no_data_colour());
  EXPECT_EQ(palette_colour(Palette::Viridis, -3.0), palette_colour(Palette::Viridis, 0.0));
  EXPECT_EQ(palette_colour(Palette::Viridis, 7.0), palette_colour(Palette::Viridis, 1.0));
  const Colour grey = no_data_colour();
  EXPECT_TRUE(grey[0] == grey[1] && grey[1] == grey[2]);
}

// Dichromats by Vienot, Brettel and Mollon (1999): red and green cones answer as one.
Vec3 as_seen_by_protanopes(const Vec3& rgb) {
  const double x = 0.11238 * rgb.x() + 0.88762 * rgb.y();
  return {x, x, 0.00401 * rgb.x() - 0.00401 * rgb.y() + rgb.z()};
}
Vec3 as_seen_by_deuteranopes(const Vec3& rgb) {
  const double x = 0.29275 * rgb.x() + 0.70725 * rgb.y();
  return {x, x, -0.02234 * rgb.x() + 0.02234 * rgb.y() + rgb.z()};
}

TEST(GarmentColour, FirstSixAndThePersonDifferForEveryEye) {
  for (int a = 0; a <= 6; ++a) {
    for (int b = a + 1; b <= 6; ++b) {
      const Vec3 p = linear_from(garment_colour(a)), q = linear_from(garment_colour(b));
      const auto apart = [&](auto see) {
        return (lab_from_linear(see(p)) - lab_from_linear(see(q))).norm();
      };
      // Ten units of L*a*b* are told apart at a glance.
      EXPECT_GT(apart([](const Vec3& c) { return c; }), 10.0) << a << " " << b;
      EXPECT_GT(apart(as_seen_by_protanopes), 10.0) << a << " " << b;
      EXPECT_GT(apart(as_seen_by_deuteranopes), 10.0) << a << " " << b;
    }
  }
  EXPECT_EQ(garment_colour(7), garment_colour(1));
}

TEST(ColourScale, SpansItsRange) {
  const ColourScale scale = symmetric_scale(0.02);
  EXPECT_EQ(scale.colour(-0.02), palette_colour(Palette::Diverging, 0.0));
  EXPECT_EQ(scale.colour(0.0), palette_colour(Palette::Diverging, 0.5));
  EXPECT_EQ(scale.colour(0.02), palette_colour(Palette::Diverging, 1.0));
  EXPECT_THROW(symmetric_scale(0.0), InvalidInput);
  EXPECT_THROW(symmetric_scale(std::nan("")), InvalidInput);
}

TEST(SymmetricRange, IsTheNextRoundNumberAboveNearlyAllValues) {
  EXPECT_DOUBLE_EQ(symmetric_range({-0.012F, 0.003F, -0.012F}), 0.02);
  EXPECT_DOUBLE_EQ(symmetric_range({0.05F}), 0.05);
  EXPECT_DOUBLE_EQ(symmetric_range({0.6F, -0.7F}), 1.0);
  std::vector<float> mostly_small(1000, 0.004F);
  mostly_small[17] = 9.0F;  // one wild value does not stretch the scale
  EXPECT_DOUBLE_EQ(symmetric_range(mostly_small), 0.005);
}

TEST(SymmetricRange, FallsBackWithoutValues) {
  EXPECT_DOUBLE_EQ(symmetric_range({}, 0.03), 0.03);
  EXPECT_DOUBLE_EQ(symmetric_range({std::nanf(""), 0.0F}, 0.03), 0.03);
}

TEST(ColourBar, RunsFromLowToHigh) {
  const Image bar = colour_bar(symmetric_scale(1.0), 201, 2);
  const Colour middle = palette_colour(Palette::Diverging, 0.5);
  EXPECT_EQ(bar.at(100, 1), (Rgba{middle[0], middle[1], middle[2], 255}));
  EXPECT_GT(bar.at(0, 0).b, bar.at(0, 0).r);
  EXPECT_GT(bar.at(200, 0).r, bar.at(200, 0).b);
}

TEST(LabelColour, IsThatOfTheGarmentWhereItIsSureAndNearsOneColourWhereItIsNot) {
  const auto off = [](Colour a, Colour b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
  };
  for (const int label : {0, 1, 2}) {
    EXPECT_EQ(label_colour(label, 1.0F), garment_colour(label));
    int last = off(garment_colour(label), unsure_colour());
    for (const float p : {0.9F, 0.75F, 0.6F, 0.5F}) {
      const int now = off(label_colour(label, p), unsure_colour());
      EXPECT_LT(now, last) << label << ", " << p;
      last = now;
    }
    EXPECT_EQ(label_colour(label, 0.2F), label_colour(label, 0.5F));
  }
}

TEST(CssColour, WritesHexadecimal) { EXPECT_EQ(css_colour({1, 171, 255}), "#01abff"); }

}  // namespace
}  // namespace regarment
