#include "garment/pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "garment/springs.h"
#include "garment_samples.h"

namespace regarment {
namespace {

class EachGarment : public testing::TestWithParam<std::string> {
 protected:
  GarmentTemplate garment = find_template(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Pattern, EachGarment, testing::Values("skirt", "tshirt"),
                         [](const auto& garment) { return garment.param; });

TEST_P(EachGarment, IsTheSameMadeAtOnceOrMovedThere) {
  Pattern moved = make_pattern(garment, garment.typical(), 0.05);
  for (const Dimensions& d : test::possible_dimensions(garment, 20)) {
    const Pattern made = make_pattern(garment, d, 0.05);
    move_pattern(garment, d, moved);
    ASSERT_EQ(made.flat.size(), moved.flat.size());
    for (std::size_t v = 0; v < made.flat.size(); ++v) EXPECT_EQ(made.flat[v], moved.flat[v]);
    EXPECT_EQ(made.triangles, moved.triangles);
    EXPECT_EQ(made.particle, moved.particle);
  }
  move_pattern(garment, garment.typical(), moved);
  EXPECT_EQ(moved.flat, make_pattern(garment, garment.typical(), 0.05).flat);
}

TEST_P(EachGarment, FollowsItsCoarsePointsByWeightsThatSumToOne) {
  const Pattern pattern = make_pattern(garment, garment.typical(), 0.03);
  const std::vector<Vec2> coarse = coarse_points(garment, garment.typical());
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    EXPECT_NEAR(pattern.barycentric[v].sum(), 1.0, 1e-14);
    EXPECT_GE(pattern.barycentric[v].minCoeff(), -1e-9);  // inside, but for rounding on a border
    // An affine map of the coarse points is the same affine map of every fine one.
    Vec2 mapped = Vec2::Zero();
    const auto map = [](const Vec2& p) {
      return Vec2(2.0 * p.x() - 0.5 * p.y() + 3.0, p.x() + 0.25 * p.y());
    };
    for (std::size_t k = 0; k < 3; ++k)
      mapped += pattern.barycentric[v][static_cast<int>(k)] *
                map(coarse[static_cast<std::size_t>(pattern.coarse_points[v][k])]);
    EXPECT_LT((mapped - map(pattern.flat[v])).norm(), 1e-13);
  }
}

TEST_P(EachGarment, NeverInvertsATriangleWithinItsBounds) {
  for (const double edge_length : {0.5, 0.1, 0.05, 0.03, 0.02}) {
    Pattern pattern = make_pattern(garment, garment.typical(), edge_length);
    const auto samples = test::possible_dimensions(garment, 150);
    ASSERT_EQ(samples.size(), 150u);
    for (const Dimensions& d : samples) {
      move_pattern(garment, d, pattern);
      const std::vector<double> areas = triangle_areas(pattern);
      EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0.0) << "edges of " << edge_length;
    }
  }
}

TEST_P(EachGarment, LooksTheSameFromLeftAndRightFrontAndBack) {
  const Pattern pattern = make_pattern(garment, garment.typical(), 0.03);
  // A triangle as its three corners in the plane, in an order that does not depend on numbering.
  using Corners = std::vector<std::pair<double, double>>;
  const auto corners = [&](const Triangle& t, double side) {
    Corners all;
    for (const std::uint32_t v : t)
      all.emplace_back(side * pattern.flat[v].x() + 0.0, pattern.flat[v].y());
    std::sort(all.begin(), all.end());
    return all;
  };
  std::multiset<Corners> front, front_mirrored, back;
  for (const Triangle& t : pattern.triangles) {
    if (pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[t[0]])]) {
      front.insert(corners(t, 1.0));
      front_mirrored.insert(corners(t, -1.0));
    } else {
      back.insert(corners(t, 1.0));
    }
  }
  EXPECT_EQ(front, front_mirrored);
  EXPECT_EQ(front, back);
}

TEST_P(EachGarment, HasEdgesOfAboutTheLengthAskedForAndFairAngles) {
  for (const double edge_length : {0.05, 0.03, 0.02}) {
    const Pattern pattern = make_pattern(garment, garment.typical(), edge_length);
    double mean = 0.0, longest = 0.0;
    const std::vector<Spring> all = springs(pattern);
    for (const Spring& s : all) {
      mean += s.rest_length / static_cast<double>(all.size());
      longest = std::max(longest, s.rest_length);
    }
    EXPECT_NEAR(mean, edge_length, 0.15 * edge_length);
    EXPECT_LT(longest, 2.0 * edge_length);
    double smallest = 180.0;
    for (const Triangle& t : pattern.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 b = pattern.flat[t[(k + 1) % 3]] - pattern.flat[t[k]];
        const Vec2 c = pattern.flat[t[(k + 2) % 3]] - pattern.flat[t[k]];
        smallest = std::min(smallest, std::acos(b.dot(c) / b.norm() / c.norm()));
      }
    EXPECT_GT(smallest, 10.0 * std::acos(-1.0) / 180.0);
  }
}

TEST_P(EachGarment, RefusesImpossibleRequestsAndKeepsThePattern) {
  EXPECT_THROW(make_pattern(garment, garment.typical(), 0.0), InvalidInput);
  EXPECT_THROW(make_pattern(garment, garment.typical(), std::nan("")), InvalidInput);
  EXPECT_THROW(make_pattern(garment, {}, 0.05), InvalidInput);
  Pattern pattern = make_pattern(garment, garment.typical(), 0.05);
  const std::vector<Vec2> before = pattern.flat;
  Dimensions stub = garment.typical();
  stub["length"] = 0.05;
  EXPECT_THROW(move_pattern(garment, stub, pattern), InvalidInput);
  EXPECT_EQ(pattern.flat, before);
}

TEST(Pattern, WrapsTheLimbsItNames) {
  const Pattern shirt =
      make_pattern(find_template("tshirt"), find_template("tshirt").typical(), 0.05);
  EXPECT_EQ(shirt.panel_limbs, (std::vector<std::string>{"torso", "torso", "left_arm", "left_arm",
                                                         "right_arm", "right_arm"}));
  EXPECT_EQ(shirt.panel_is_front, (std::vector<bool>{true, false, true, false, true, false}));
  for (std::size_t v = 0; v < shirt.flat.size(); ++v) {
    const std::string& limb = shirt.panel_limbs[static_cast<std::size_t>(shirt.panel[v])];
    if (limb == "torso") continue;
    EXPECT_EQ(shirt.flat[v].x() > 0.0, limb == "left_arm");  // the wearer's left is at s > 0
  }
}

}  // namespace
}  // namespace regarment
