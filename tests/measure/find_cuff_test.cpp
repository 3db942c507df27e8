#include "measure/find_cuff.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kShoulder = 1.4;               // m above the floor, where s = 0
constexpr double kEdge = 0.152, kFold = 0.277;  // m along the arm: between two rows of its map
constexpr ArmStretch kArm{0.05, 0.45};

/// A straight round arm that hangs `degrees` below level. Cloth of 3 mm ends at kEdge; at kFold it
/// becomes thinner by 5 mm at once, which shows more than the edge does.
LimbView arm(double degrees) {
  const double turn = degrees * std::numbers::pi / 180;
  const Vec3 from(0.2, kShoulder, 0), along(std::cos(turn), -std::sin(turn), 0);
  LimbMap map;
  map.s_low = 0.002, map.step = 0.005, map.rows = 96, map.columns = 40;
  map.count.assign(static_cast<std::size_t>(map.rows * map.columns), 2);
  for (int i = 0; i < map.rows; ++i)
    for (int j = 0; j < map.columns; ++j)
      map.radius.push_back(0.045 + (map.row_s(i) < kEdge ? 0.003 : 0) +
                           (map.row_s(i) < kFold ? 0.005 : 0));
  return {LimbAxis({from, from + 0.5 * along}, {0.0, 0.5}, Vec3::UnitY()), std::move(map), {}};
}

double height(double s, double degrees) {
  return kShoulder - s * std::sin(degrees * std::numbers::pi / 180);
}

std::optional<Cuff> find(double degrees, std::optional<double> said) {
  return find_cuff(arm(degrees), "left_cuff", "left_arm", kArm, said);
}

TEST(FindCuff, GoesWhereMostShowsWithoutHelp) {
  const auto cuff = find(40, {});
  ASSERT_TRUE(cuff);
  EXPECT_NEAR(cuff->places.front().mean_s(), kFold, 0.003);  // half a row of the map
  EXPECT_FALSE(cuff->clearest);
}

TEST(FindCuff, IsTakenFromWhereAPersonSeesIt) {
  for (const double degrees : {30.0, 40.0, 80.0}) {
    // A person points 1 cm beside it.
    const auto cuff = find(degrees, height(kEdge, degrees) + 0.01);
    ASSERT_TRUE(cuff);
    ASSERT_EQ(cuff->places.size(), 1U);
    EXPECT_NEAR(cuff->places.front().mean_s(), kEdge, 0.003) << degrees;
    ASSERT_TRUE(cuff->clearest);
    EXPECT_NEAR(cuff->clearest->mean_s(), kFold, 0.003);
  }
}

TEST(FindCuff, RefusesAHeightThatTheArmDoesNotHave) {
  EXPECT_THROW(find(40, kShoulder + 0.2), UsageError);
  EXPECT_THROW(find(40, height(kArm.s_high, 40) - 0.1), UsageError);
}

TEST(FindCuff, RefusesAHeightOnALevelArm) {
  EXPECT_THROW(find(10, height(kEdge, 10)), UsageError);
  EXPECT_NO_THROW(find(25, height(kEdge, 25)));
}

TEST(FindCuff, RefusesAHeightWhereNothingIsSeen) {
  LimbView bare = arm(40);
  std::fill(bare.map.count.begin(), bare.map.count.end(), 0);
  EXPECT_THROW(find_cuff(bare, "left_cuff", "left_arm", kArm, height(kEdge, 40)), UsageError);
}

TEST(FindCuff, HasNoPlaceOnAnArmTooShort) {
  EXPECT_FALSE(find_cuff(arm(40), "left_cuff", "left_arm", {0.1, 0.105}, {}));
}

}  // namespace
}  // namespace regarment
