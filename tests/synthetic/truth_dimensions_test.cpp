#include "synthetic/truth_dimensions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "base/error.h"
#include "garment/find_template.h"
#include "synthetic/truth_lines.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;

// A garment spread out on a table, stretched across and along its panels.
WornGarment on_table(const GarmentTemplate& garment, const Dimensions& dimensions, double across,
                     double along) {
  WornGarment worn;
  worn.template_name = garment.name();
  worn.dimensions = dimensions;
  worn.pattern = make_pattern(garment, dimensions, 0.03);
  worn.particles.resize(static_cast<std::size_t>(worn.pattern.particle_count));
  for (std::size_t v = 0; v < worn.pattern.flat.size(); ++v) {
    const Vec2& p = worn.pattern.flat[v];
    worn.particles[static_cast<std::size_t>(worn.pattern.particle[v])] =
        Vec3(across * p.x(), -along * p.y(), 0);
  }
  return worn;
}

std::set<std::string> hidden(const GarmentTemplate& garment, const WornGarment& worn,
                             const std::vector<std::uint8_t>& seen) {
  const auto names = hidden_dimensions(garment, worn, seen);
  return {names.begin(), names.end()};
}

// Sees the particles whose flat t (of any of their vertices) passes a test.
template <typename Test>
std::vector<std::uint8_t> see(const WornGarment& worn, const Test& test) {
  std::vector<std::uint8_t> seen(worn.particles.size(), 0);
  for (std::size_t v = 0; v < worn.pattern.flat.size(); ++v) {
    if (test(worn.pattern.flat[v])) seen[static_cast<std::size_t>(worn.pattern.particle[v])] = 1;
  }
  return seen;
}

TEST(WornDimensions, OfAGarmentOnATableAreTheFlatOnes) {
  for (const char* name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    const WornGarment worn = on_table(garment, garment.typical(), 1, 1);
    for (const auto& [dimension, value] : worn_dimensions(garment, worn)) {
      EXPECT_NEAR(value, garment.typical().at(dimension), 1e-6) << name << " " << dimension;
    }
  }
}

TEST(WornDimensions, FollowTheStretchInTheirDirection) {
  const GarmentTemplate garment = find_template("skirt");
  const Dimensions flat = garment.typical();
  const Dimensions worn = worn_dimensions(garment, on_table(garment, flat, 1.05, 0.9));
  EXPECT_NEAR(worn.at("waist"), 1.05 * flat.at("waist"), 1e-6);
  EXPECT_NEAR(worn.at("hip"), 1.05 * flat.at("hip"), 1e-6);
  EXPECT_NEAR(worn.at("width"), 1.05 * flat.at("width"), 1e-6);
  EXPECT_NEAR(worn.at("length"), 0.9 * flat.at("length"), 1e-6);
}

TEST(WornDimensions, OfASleeveFollowItsOwnSlope) {
  // The upper edge falls 28 degrees: stretched 1.1 across and 0.8 along it is this much longer.
  const GarmentTemplate garment = find_template("tshirt");
  const Dimensions flat = garment.typical();
  const Dimensions worn = worn_dimensions(garment, on_table(garment, flat, 1.1, 0.8));
  const double slope = 28 * kPi / 180;
  const double along = std::hypot(1.1 * std::cos(slope), 0.8 * std::sin(slope));
  const double across = std::hypot(1.1 * std::sin(slope), 0.8 * std::cos(slope));
  EXPECT_NEAR(worn.at("sleeve_length"), along * flat.at("sleeve_length"), 1e-6);
  EXPECT_NEAR(worn.at("sleeve_opening"), across * flat.at("sleeve_opening"), 1e-6);
  EXPECT_NEAR(worn.at("length"), 0.8 * flat.at("length"), 1e-6);
}

TEST(WornDimensions, AreTheMeanOfBothSides) {
  // The left half is stretched, the right is not.
  const GarmentTemplate garment = find_template("tshirt");
  const Dimensions flat = garment.typical();
  WornGarment worn = on_table(garment, flat, 1, 1);
  for (Vec3& p : worn.particles) p.x() *= p.x() > 0 ? 1.2 : 1.0;
  EXPECT_NEAR(worn_dimensions(garment, worn).at("width"), 1.1 * flat.at("width"), 1e-6);
}

TEST(DimensionLines, LieOnFrontAndBackOnBothSides) {
  const GarmentTemplate garment = find_template("tshirt");
  const Dimensions flat = garment.typical();
  const Pattern pattern = make_pattern(garment, flat, 0.03);
  const auto count = [&](const char* name) {
    return dimension_lines(garment, pattern, flat, name).size();
  };
  EXPECT_EQ(count("length"), 4U);         // front and back, left and right of the neck
  EXPECT_EQ(count("sleeve_length"), 4U);  // four sleeve panels
  EXPECT_EQ(count("sleeve_opening"), 4U);
  EXPECT_EQ(count("sleeve_seam"), 8U);  // body and sleeve, on either side of each seam
  EXPECT_THROW(dimension_lines(garment, pattern, flat, "collar"), InvalidInput);
}

TEST(HiddenDimensions, AreNoneOfWhatIsSeenAndAllOfWhatIsNot) {
  for (const char* name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    const WornGarment worn = on_table(garment, garment.typical(), 1, 1);
    std::vector<std::uint8_t> seen(worn.particles.size(), 1);
    EXPECT_TRUE(hidden_dimensions(garment, worn, seen).empty());
    std::fill(seen.begin(), seen.end(), std::uint8_t{0});
    EXPECT_EQ(hidden_dimensions(garment, worn, seen).size(), garment.dimensions().size());
    seen.pop_back();
    EXPECT_THROW(hidden_dimensions(garment, worn, seen), InvalidInput);
  }
}

TEST(HiddenDimensions, OfASkirtUnderATshirt) {
  const GarmentTemplate garment = find_template("skirt");
  const WornGarment worn = on_table(garment, garment.typical(), 1, 1);
  using Names = std::set<std::string>;
  const auto below = [&](double t) {
    return hidden(garment, worn, see(worn, [&](const Vec2& p) { return p.y() > t; }));
  };
  EXPECT_EQ(below(0.1), (Names{"waist", "length"}));  // the hip line lies 20 cm down
  EXPECT_EQ(below(0.3), (Names{"waist", "length", "hip"}));
}

TEST(HiddenDimensions, HalfAnEdgeIsEnough) {
  const GarmentTemplate garment = find_template("skirt");
  const WornGarment worn = on_table(garment, garment.typical(), 1, 1);
  const double quarter = garment.typical().at("width") / 4;
  const auto up_to = [&](double share) {
    return hidden(garment, worn,
                  see(worn, [&](const Vec2& p) { return p.x() < (2 * share - 1) * quarter; }));
  };
  EXPECT_EQ(up_to(0.6).count("width"), 0U);
  EXPECT_EQ(up_to(0.35).count("width"), 1U);
}

TEST(HiddenDimensions, OfATshirtTuckedIn) {
  // Its width shows at the chest, its length does not.
  const GarmentTemplate garment = find_template("tshirt");
  const WornGarment worn = on_table(garment, garment.typical(), 1, 1);
  const auto seen = see(worn, [&](const Vec2& p) { return p.y() < 0.5; });
  EXPECT_EQ(hidden(garment, worn, seen), std::set<std::string>{"length"});
}

}  // namespace
}  // namespace regarment
