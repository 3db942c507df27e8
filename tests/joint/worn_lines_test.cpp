#include "joint/worn_lines.h"

#include <gtest/gtest.h>

#include "rolled_skirt.h"

namespace regarment {
namespace {

// Without the curved cloth between its points a tube of 2.5 cm triangles would be 0.1 % short.
TEST(WornLines, AreTheDimensionsOfClothThatIsNotStretched) {
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions made = tube_dimensions(1.0, 0.6);
  const Pattern pattern = make_pattern(skirt, made, 0.05);
  const auto worn = worn_lines(skirt, made, pattern, rolled(pattern, 1.0, 0.5 / std::numbers::pi));
  ASSERT_EQ(worn.size(), made.size());
  for (const auto& [name, length] : worn) EXPECT_NEAR(length, made.at(name), 5e-4) << name;
}

TEST(WornLines, GrowWithTheClothAroundAndNotAlong) {
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions made = tube_dimensions(1.0, 0.6);
  const Pattern pattern = make_pattern(skirt, made, 0.03);
  const auto worn =
      worn_lines(skirt, made, pattern, rolled(pattern, 1.0, 1.05 * 0.5 / std::numbers::pi));
  EXPECT_NEAR(worn.at("waist"), 1.05, 5e-4);
  EXPECT_NEAR(worn.at("hip"), 1.05, 5e-4);
  EXPECT_NEAR(worn.at("length"), 0.6, 5e-4);
}

TEST(WornLines, LieOnEveryPanelOfAFlatGarment) {
  const GarmentTemplate shirt = find_template("tshirt");
  const Dimensions made = shirt.typical();
  const Pattern pattern = make_pattern(shirt, made, 0.03);
  std::vector<Vec3> flat;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    flat.emplace_back(pattern.flat[v].x(), -pattern.flat[v].y(), 0);
  const auto worn = worn_lines(shirt, made, pattern, flat);
  for (const auto& [name, value] : made) EXPECT_NEAR(worn.at(name), value, 1e-3) << name;
}

TEST(ArcOverChord, IsThatOfACircle) {
  for (const double half : {0.01, 0.2, 0.7}) {
    const Vec3 chord(2 * std::sin(half), 0, 0);
    const Vec3 a(-std::sin(half), std::cos(half), 0), b(std::sin(half), std::cos(half), 0);
    EXPECT_NEAR(arc_over_chord(chord, a, b), half / std::sin(half), 1e-12);
    EXPECT_NEAR(arc_over_chord(chord, b, a), half / std::sin(half), 1e-12);
  }
  EXPECT_EQ(arc_over_chord({0.1, 0, 0}, Vec3::Zero(), Vec3::UnitY()), 1);
}

}  // namespace
}  // namespace regarment
