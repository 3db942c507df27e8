#include "placement/limb_map.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/limbs.h"

namespace regarment {
namespace {

using test::LimbPlan;

constexpr double kPi = std::numbers::pi;

LimbPlan cylinder(double radius) {
  LimbPlan plan;
  plan.radius = [radius](double, double) { return radius; };
  return plan;
}

TEST(LimbMap, OfACylinderHasItsRadiusInEveryCell) {
  const LimbMap map = test::limb_map(cylinder(0.15), 1, 72, 0.008);
  EXPECT_EQ(map.rows, 75);
  int empty = 0;
  for (int i = 0; i < map.rows; ++i)
    for (int j = 0; j < map.columns; ++j) {
      if (!map.has(i, j)) {
        ++empty;
        continue;
      }
      ASSERT_NEAR(map.radius[map.index(i, j)], 0.15, 1e-12);
    }
  EXPECT_EQ(empty, 0);
}

TEST(LimbMap, OfAConeHasTheRadiusOfItsRows) {
  LimbPlan plan;
  const auto radius = [](double s) { return 0.30 - 0.25 * (s - 0.4); };
  plan.radius = [&](double s, double) { return radius(s); };
  const LimbMap map = test::limb_map(plan, 2);
  for (int i = 0; i < map.rows; ++i)
    for (int j = 0; j < map.columns; ++j) {
      if (!map.has(i, j)) continue;
      // The mean of points somewhere in the row: off its middle by at most half a row.
      ASSERT_NEAR(map.radius[map.index(i, j)], radius(map.row_s(i)), 0.25 * map.step / 2 + 1e-12);
    }
}

TEST(LimbMap, PutsEachDirectionIntoItsColumn) {
  LimbPlan plan;
  plan.radius = [](double, double phi) { return 0.2 + 0.05 * std::cos(phi - 1.0); };
  const LimbMap map = test::limb_map(plan, 3);
  for (int i = 0; i < map.rows; ++i)
    for (int j = 0; j < map.columns; ++j)
      if (map.has(i, j)) {
        ASSERT_NEAR(map.radius[map.index(i, j)], 0.2 + 0.05 * std::cos(map.column_phi(j) - 1.0),
                    0.05 * kPi / map.columns + 1e-9);
      }
  EXPECT_NEAR(map.column_phi(-0.5), -kPi, 1e-12);
  EXPECT_NEAR(map.column_phi(map.columns - 0.5), kPi, 1e-12);
  EXPECT_EQ(map.index(3, -1), map.index(3, map.columns - 1));
  EXPECT_EQ(map.index(3, map.columns), map.index(3, 0));
  EXPECT_NEAR(map.row_of(map.row_s(17)), 17, 1e-9);
}

TEST(LimbMap, IgnoresALayerHiddenInside) {
  SurfaceSamples both = test::limb_samples(cylinder(0.15), 4);
  const SurfaceSamples inner = test::limb_samples(cylinder(0.135), 5);
  both.positions.insert(both.positions.end(), inner.positions.begin(), inner.positions.end());
  both.normals.insert(both.normals.end(), inner.normals.begin(), inner.normals.end());
  const LimbMap map =
      make_limb_map(both, test::all_of(both), test::upright_axis(0, 1), 0.4, 1.0, 0.006, 96);
  for (int i = 0; i < map.rows; ++i)
    for (int j = 0; j < map.columns; ++j) {
      ASSERT_TRUE(map.has(i, j));
      ASSERT_NEAR(map.radius[map.index(i, j)], 0.15, 1e-12);
    }
}

TEST(LimbMap, IgnoresWhatFacesTheAxisOrAlongIt) {
  SurfaceSamples samples = test::limb_samples(cylinder(0.15), 6);
  SurfaceSamples inside_out = test::limb_samples(cylinder(0.2), 7);
  for (std::size_t i = 0; i < inside_out.size(); ++i) {
    samples.positions.push_back(inside_out.positions[i]);
    samples.normals.push_back(i % 2 == 0 ? Vec3(-inside_out.normals[i]) : Vec3(-Vec3::UnitY()));
  }
  const LimbMap map =
      make_limb_map(samples, test::all_of(samples), test::upright_axis(0, 1), 0.4, 1.0, 0.006, 96);
  for (std::size_t c = 0; c < map.radius.size(); ++c) ASSERT_NEAR(map.radius[c], 0.15, 1e-12);
}

TEST(LimbMap, IsEmptyWhereThereIsNoData) {
  LimbPlan plan = cylinder(0.15);
  plan.missing = [](double s, double phi) { return s > 0.6 && s < 0.7 && phi > 0; };
  const LimbMap map = test::limb_map(plan, 8, 72, 0.008);
  for (int i = 0; i < map.rows; ++i)
    for (int j = 0; j < map.columns; ++j) {
      const bool hole = map.row_s(i) > 0.604 && map.row_s(i) < 0.696 && map.column_phi(j) > 0;
      if (hole) {
        EXPECT_FALSE(map.has(i, j));
        EXPECT_TRUE(std::isnan(map.radius[map.index(i, j)]));
      }
      if (map.row_s(i) < 0.59) {
        EXPECT_TRUE(map.has(i, j));
      }
    }
}

TEST(LimbMap, AveragesColours) {
  LimbPlan plan = cylinder(0.15);
  plan.colour = [](double s, double) { return s < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 0.5, 1); };
  const LimbMap map = test::limb_map(plan, 9, 72, 0.008);
  ASSERT_EQ(map.colour.size(), map.radius.size());
  for (int i = 0; i < map.rows; ++i) {
    if (std::abs(map.row_s(i) - 0.7) < 0.008) continue;
    const Vec3 expected = map.row_s(i) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 0.5, 1);
    for (int j = 0; j < map.columns; ++j)
      ASSERT_LT((map.colour[map.index(i, j)] - expected).norm(), 1e-12);
  }
  EXPECT_TRUE(test::limb_map(cylinder(0.15), 9).colour.empty());
}

}  // namespace
}  // namespace regarment
