#include "measure/tucked_cuff.h"

#include <gtest/gtest.h>

#include <numbers>

namespace regarment {
namespace {

constexpr double kArmpit = 1.3;  // m above the floor

/// A round cuff of radius 5 cm, perpendicular to a straight arm that leaves the armpit's level
/// 6 cm higher.
struct Sleeve {
  double angle = 40;  // degrees of the arm from straight down
  double at = 0.04;   // m from the armpit along the arm
  double armpit = kArmpit;
  bool covered = false;

  GarmentEdges edges() const {
    const double turn = angle * std::numbers::pi / 180;
    const Vec3 from(0.2, kArmpit + 0.06, 0), along(std::sin(turn), -std::cos(turn), 0);
    LimbAxis axis({from - 0.1 * along, from + 0.5 * along}, {-0.1, 0.5}, Vec3::UnitY());
    LimbMap map;
    map.columns = 40;
    GarmentEdges out;
    out.limbs.emplace("left_arm", LimbView{std::move(axis), std::move(map), {}});
    GarmentEdge cuff;
    cuff.limb = "left_arm", cuff.garment_above = false, cuff.covered = covered;
    cuff.found.s.assign(40, at), cuff.found.r.assign(40, 0.05);
    out.edges["left_cuff"] = cuff;
    return out;
  }
  Body body() const {
    Body out;
    out.armpit = {armpit, armpit};
    return out;
  }
  bool tucked() const {
    const GarmentEdges all = edges();
    return is_tucked(all.edges.at("left_cuff"), all, body());
  }
};

// The lowest point of the cuff lies kArmpit + 0.06 - at cos(angle) - 0.05 sin(angle) above the
// floor.

TEST(TuckedCuff, ClosesInTheArmpit) {
  EXPECT_TRUE(Sleeve{}.tucked());                   // 0.3 cm below the armpit
  EXPECT_FALSE((Sleeve{40, 0.08}.tucked()));        // 3.3 cm below it: seen from all sides
  EXPECT_FALSE((Sleeve{40, 0.04, 1.33}.tucked()));  // the armpit is 3 cm higher
}

TEST(TuckedCuff, HangsFreeOnRaisedArmsAndFarDownTheArm) {
  EXPECT_TRUE((Sleeve{60, 0.04}.tucked()));
  EXPECT_FALSE((Sleeve{80, 0.04}.tucked()));
  EXPECT_FALSE((Sleeve{60, 0.10, 1.25}.tucked()));
  EXPECT_TRUE((Sleeve{60, 0.08, 1.25}.tucked()));
}

TEST(TuckedCuff, NeedsAnArmpitAndAnEdge) {
  EXPECT_FALSE((Sleeve{40, 0.04, 0}.tucked()));
  EXPECT_FALSE((Sleeve{40, 0.04, kArmpit, true}.tucked()));
  GarmentEdges edges = Sleeve{}.edges();
  edges.edges["left_cuff"].found = {};
  EXPECT_FALSE(is_tucked(edges.edges["left_cuff"], edges, Sleeve{}.body()));
}

TEST(TuckedCuff, CountsEverySleeve) {
  const Body body = Sleeve{}.body();
  GarmentEdges edges = Sleeve{}.edges();
  EXPECT_EQ(tucked_share(edges, body), 1);
  GarmentEdge other = Sleeve{40, 0.08}.edges().edges.at("left_cuff");
  edges.edges["right_cuff"] = other;
  EXPECT_EQ(tucked_share(edges, body), 0.5);
  edges.edges["hem"].limb = "torso";
  EXPECT_EQ(tucked_share(edges, body), 0.5);
  EXPECT_EQ(tucked_share(GarmentEdges{}, body), 0);
}

}  // namespace
}  // namespace regarment
