#include "placement/slices.h"

#include <gtest/gtest.h>

#include <set>

#include "support/dice.h"

namespace regarment {
namespace {

using test::Dice;

SurfaceSamples random_samples(std::size_t count, double width, double top, std::uint64_t seed) {
  Dice dice(seed);
  SurfaceSamples samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.positions.emplace_back(dice.uniform(-width, width), dice.uniform(-0.02, top),
                                   dice.uniform(-width, width));
    samples.normals.push_back(Vec3::UnitX());
    samples.areas.push_back(dice.uniform(1e-6, 1e-4));
    samples.vertex.push_back(static_cast<std::uint32_t>(i));
  }
  return samples;
}

/// Groups found by joining every pair whose cells touch until nothing changes: slow and plain.
std::set<std::set<int>> groups_of(const SurfaceSamples& samples, const std::vector<int>& members,
                                  double cell) {
  std::vector<std::set<int>> groups;
  const auto touch = [&](int a, int b) {
    const Vec3 d = (samples.positions[a] / cell).array().floor() -
                   (samples.positions[b] / cell).array().floor();
    return std::abs(d.x()) < 1.5 && std::abs(d.z()) < 1.5;
  };
  for (int m : members) {
    std::set<int> joined{m};
    std::vector<std::set<int>> others;
    for (std::set<int>& g : groups) {
      if (std::any_of(g.begin(), g.end(), [&](int k) { return touch(k, m); }))
        joined.insert(g.begin(), g.end());
      else
        others.push_back(std::move(g));
    }
    others.push_back(std::move(joined));
    groups = std::move(others);
  }
  return {groups.begin(), groups.end()};
}

TEST(SliceBody, FindsTheClustersThatTouchingCellsMake) {
  // From sparse dust to one piece, so that clusters of all sizes occur.
  std::size_t clusters = 0;
  for (const double width : {0.9, 0.35, 0.2, 0.1}) {
    const SurfaceSamples samples = random_samples(600, width, 0.06, 7);
    const Slices slices = slice_body(samples, 0.02, 0.012);
    for (std::size_t i = 0; i < slices.levels.size(); ++i) {
      std::vector<int> members;
      for (std::size_t s = 0; s < samples.size(); ++s) {
        const double level = std::max(0.0, std::floor(samples.positions[s].y() / 0.02));
        if (level == static_cast<double>(i)) members.push_back(static_cast<int>(s));
      }
      std::set<std::set<int>> found;
      for (const SliceCluster& c : slices.levels[i])
        found.emplace(c.samples.begin(), c.samples.end());
      EXPECT_EQ(found, groups_of(samples, members, 0.012)) << "level " << i << ", width " << width;
      clusters += found.size();
    }
  }
  EXPECT_GT(clusters, 500U);  // the random points did make many pieces
}

TEST(SliceBody, KeepsExtentAreaAndOrderOfEachCluster) {
  const SurfaceSamples samples = random_samples(800, 0.3, 0.2, 11);
  const Slices slices = slice_body(samples);
  ASSERT_EQ(slices.levels.size(), 20U);
  EXPECT_DOUBLE_EQ(slices.height, 0.01);
  std::size_t total = 0;
  for (const auto& level : slices.levels) {
    for (std::size_t k = 0; k < level.size(); ++k) {
      const SliceCluster& c = level[k];
      if (k > 0) {
        EXPECT_GE(level[k - 1].area, c.area);
      }
      EXPECT_TRUE(std::is_sorted(c.samples.begin(), c.samples.end()));
      double area = 0, x_min = 1e9, x_max = -1e9, z_min = 1e9, z_max = -1e9;
      for (int s : c.samples) {
        const Vec3& p = samples.positions[s];
        area += samples.areas[s];
        x_min = std::min(x_min, p.x()), x_max = std::max(x_max, p.x());
        z_min = std::min(z_min, p.z()), z_max = std::max(z_max, p.z());
      }
      EXPECT_NEAR(c.area, area, 1e-15);
      EXPECT_EQ(c.x_min, x_min);
      EXPECT_EQ(c.x_max, x_max);
      EXPECT_EQ(c.z_min, z_min);
      EXPECT_EQ(c.z_max, z_max);
      EXPECT_DOUBLE_EQ(c.width(), x_max - x_min);
      EXPECT_DOUBLE_EQ(c.depth(), z_max - z_min);
      total += c.samples.size();
    }
  }
  EXPECT_EQ(total, samples.size());  // what lies below the floor too
}

TEST(SliceBody, PutsSamplesBelowTheFloorIntoTheLowestSlice) {
  SurfaceSamples samples;
  for (const double y : {-0.5, -0.001, 0.005, 0.015}) {
    samples.positions.emplace_back(0, y, 0);
    samples.areas.push_back(1);
  }
  const Slices slices = slice_body(samples, 0.01);
  ASSERT_EQ(slices.levels.size(), 2U);
  ASSERT_EQ(slices.levels[0].size(), 1U);
  EXPECT_EQ(slices.levels[0][0].samples, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(slices.levels[1][0].samples, (std::vector<int>{3}));
}

}  // namespace
}  // namespace regarment
