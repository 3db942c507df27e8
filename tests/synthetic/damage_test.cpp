#include "synthetic/damage.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"

namespace regarment {
namespace {

/// A wall of 1 m x 1 m, a point each centimetre.
ScannedPerson wall() {
  ScannedPerson scan;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      scan.cloud.positions.emplace_back(0.01 * i, 0.01 * j, 0);
      scan.cloud.normals.emplace_back(0, 0, 1);
      scan.cloud.colours.push_back({1, 2, 3});
      scan.labels.push_back(i < 50 ? 0 : 1);
      scan.particle.push_back(i < 50 ? ScannedPerson::kNone : static_cast<std::uint32_t>(j));
    }
  return scan;
}

std::set<std::pair<double, double>> places(const ScannedPerson& scan) {
  std::set<std::pair<double, double>> places;
  for (const Vec3& p : scan.cloud.positions) places.emplace(p.x(), p.y());
  return places;
}

TEST(Damage, NoneAskedForChangesNothing) {
  ScannedPerson scan = wall();
  Random random(1);
  apply_damage({}, random, scan);
  EXPECT_EQ(scan.cloud.positions, wall().cloud.positions);
}

TEST(Damage, HoleTakesWhatIsNearAndNothingElse) {
  ScannedPerson scan = wall();
  Random random(4);
  DamageOptions options;
  options.holes = 1;
  options.hole_radius = 0.05;
  apply_damage(options, random, scan);
  const auto left = places(scan);
  std::vector<Vec3> gone;
  for (const Vec3& p : wall().cloud.positions)
    if (!left.contains({p.x(), p.y()})) gone.push_back(p);
  // The first ball alone holds at least a quarter of its disc when it stands in a corner.
  EXPECT_GE(gone.size(), 15U);
  // The other two have their middles within 2 radii and are no larger: 3 radii from the middle.
  Vec3 low = gone[0], high = gone[0];
  for (const Vec3& p : gone) low = low.cwiseMin(p), high = high.cwiseMax(p);
  EXPECT_LE((high - low).maxCoeff(), 6 * options.hole_radius);
}

TEST(Damage, StrayPointsAreOutliersAtTheEnd) {
  ScannedPerson scan = wall();
  Random random(2);
  DamageOptions options;
  options.stray = 0.02;
  options.stray_reach = 0.1;
  apply_damage(options, random, scan);
  ASSERT_EQ(scan.labels.size(), 10200U);
  ASSERT_EQ(scan.cloud.colours.size(), 10200U);
  for (std::size_t i = 10000; i < scan.labels.size(); ++i) {
    EXPECT_EQ(scan.labels[i], ScannedPerson::kOutlier);
    EXPECT_EQ(scan.particle[i], ScannedPerson::kNone);
    EXPECT_NEAR(scan.cloud.normals[i].norm(), 1, 1e-12);
    EXPECT_LE(std::abs(scan.cloud.positions[i].z()), 0.1);
  }
}

TEST(Damage, SameSeedSameDamage) {
  DamageOptions options{.holes = 3, .hole_radius = 0.04, .stray = 0.01};
  ScannedPerson a = wall(), b = wall();
  Random first(7), second(7);
  apply_damage(options, first, a);
  apply_damage(options, second, b);
  EXPECT_EQ(a.cloud.positions, b.cloud.positions);
  EXPECT_EQ(a.labels, b.labels);
}

TEST(Damage, EmptyScanStaysEmpty) {
  ScannedPerson scan;
  Random random(1);
  apply_damage({.holes = 2, .stray = 0.1}, random, scan);
  EXPECT_TRUE(scan.labels.empty());
}

TEST(Damage, RefusesDamageOutOfRange) {
  EXPECT_THROW(DamageOptions{.holes = 51}.check(), InvalidInput);
  EXPECT_THROW(DamageOptions{.hole_radius = 0}.check(), InvalidInput);
  EXPECT_THROW(DamageOptions{.stray = 0.5}.check(), InvalidInput);
  EXPECT_THROW(DamageOptions{.stray_reach = -1}.check(), InvalidInput);
}

}  // namespace
}  // namespace regarment
