#include "drape/held_edge.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "cloths.h"
#include "drape/drape.h"
#include "geometry/closed_curve.h"
#include "surfaces.h"

namespace regarment {
namespace {

using namespace test;

const std::vector<Vec3> kFrame = {Vec3(-1, 0, -4), Vec3(1, 0, -4), Vec3(1, 0, 4), Vec3(-1, 0, 4)};

TEST(ClosestOnCurve, FindsSidesCornersAndTheClosingSide) {
  const auto expect = [](const Vec3& p, const Vec3& closest) {
    EXPECT_LT((closest_on_curve(kFrame, p).point - closest).norm(), 1e-12);
  };
  expect(Vec3(0.3, 2, -6), Vec3(0.3, 0, -4));
  expect(Vec3(2, 0, 5), Vec3(1, 0, 4));
  expect(Vec3(-0.9, 0, 0.25), Vec3(-1, 0, 0.25));  // from the last point to the first
  EXPECT_EQ(closest_on_curve({Vec3(1, 2, 3)}, Vec3::Zero()).point, Vec3(1, 2, 3));
}

TEST(ClosestOnCurve, AgreesWithSamplesOfACurve) {
  Dice dice(31);
  const auto anywhere = [&](double size) {
    return Vec3(dice.uniform(-size, size), dice.uniform(-size, size), dice.uniform(-size, size));
  };
  std::vector<Vec3> curve, samples;
  for (int i = 0; i < 12; ++i) curve.push_back(anywhere(0.5));
  constexpr int kPieces = 400;
  double longest = 0;  // of a piece
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec3 along = curve[(i + 1) % curve.size()] - curve[i];
    longest = std::max(longest, along.norm() / kPieces);
    for (int k = 0; k < kPieces; ++k) samples.push_back(curve[i] + k * along / kPieces);
  }
  for (int query = 0; query < 200; ++query) {
    const Vec3 p = anywhere(1), found = closest_on_curve(curve, p).point;
    double nearest = 1e9, beside = 1e9;
    for (const Vec3& sample : samples) {
      nearest = std::min(nearest, (sample - p).norm());
      beside = std::min(beside, (sample - found).norm());
    }
    EXPECT_LE((found - p).norm(), nearest + 1e-12);
    EXPECT_LE(beside, longest / 2 + 1e-12);  // it lies on the curve
  }
}

TEST(Hold, DrawsAnEdgeToItsCurve) {
  const Cloth cloth = flat_patch(2, 0.04);
  std::vector<Attraction> targets(cloth.size());
  targets[4].target = Vec3(7, 7, 7);
  hold({{{0, 1, 2}, kFrame}}, cloth, targets);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(targets[i].found && targets[i].pulls);
    EXPECT_NEAR(targets[i].distance, 0.98, 1e-12);
    EXPECT_NEAR(targets[i].target.x(), -1, 1e-12);
  }
  EXPECT_EQ(targets[4].target, Vec3(7, 7, 7));
}

TEST(Hold, RefusesWhatIsNotThere) {
  const Cloth cloth = flat_patch(2, 0.04);
  std::vector<Attraction> targets(cloth.size());
  EXPECT_THROW(hold({{{9}, kFrame}}, cloth, targets), InvalidInput);
  EXPECT_THROW(hold({{{-1}, kFrame}}, cloth, targets), InvalidInput);
  EXPECT_THROW(hold({{{0}, {}}}, cloth, targets), InvalidInput);
}

TEST(Hold, PullsADrapeAlongTheScan) {
  const Mesh mesh = sheet();
  Cloth cloth = flat_patch(6, 0.12);
  HeldEdge edge;
  for (int j = 0; j <= 6; ++j) edge.particles.push_back(j);  // the side at x = -0.06
  edge.curve = {Vec3(-0.05, 0, -1), Vec3(-0.05, 0, 1)};
  const DrapeOutcome outcome = drape(cloth, closest_on(mesh), {}, {}, {edge});
  EXPECT_EQ(outcome.ending, DrapeEnding::CameToRest);
  // Nothing holds the patch on the plane: all of it follows the edge by a centimetre.
  const std::vector<Vec3> flat = flat_patch(6, 0.12).positions;
  for (std::size_t i = 0; i < flat.size(); ++i)
    EXPECT_LT((cloth.positions[i] - flat[i] - Vec3(0.01, 0, 0)).norm(), 2e-3) << i;
}

}  // namespace
}  // namespace regarment
