#include "measure/level_fit.h"

#include <gtest/gtest.h>

#include "support/dice.h"

namespace regarment {
namespace {

constexpr double kHip = 0.2, kLength = 0.6;  // m

/// Girth of a garment cut straight from 0.7 m at the top over the hip to the hem.
double cut(double t, double hip, double hem) {
  return t < kHip ? 0.7 + (hip - 0.7) * t / kHip
                  : hip + (hem - hip) * (t - kHip) / (kLength - kHip);
}

std::vector<LevelGirth> levels(double hip, double hem, double noise = 0) {
  test::Dice dice(5);
  std::vector<LevelGirth> out;
  for (double t = 0.01; t < kLength - 0.005; t += 0.01)
    out.push_back({t, cut(t, hip, hem) + (noise > 0 ? dice.normal(noise) : 0.0), 0});
  return out;
}

TEST(GirthAtLevel, MeetsTheCornerOfTheCut) {
  for (const double hem : {0.8, 1.0, 1.6})
    EXPECT_NEAR(girth_at_level(levels(1.0, hem), kHip, 0.06).value, 1.0, 1e-6) << hem;
  // One line over both sides would miss it by far.
  EXPECT_NEAR(girth_at_level(levels(1.0, 1.0, 0.002), kHip, 0.06).value, 1.0, 0.005);
}

TEST(GirthAtLevel, GoesOnStraightToAnEdge) {
  EXPECT_NEAR(girth_at_level(levels(1.0, 1.2), 0, 0.07).value, 0.7, 1e-6);
  EXPECT_NEAR(girth_at_level(levels(1.0, 1.2), kLength, 0.07).value, 1.2, 1e-6);
}

TEST(GirthAtLevel, OneWrongLevelHardlyCounts) {
  std::vector<LevelGirth> some = levels(1.0, 1.2);
  some[19].girth += 0.3;
  EXPECT_NEAR(girth_at_level(some, kHip, 0.06).value, 1.0, 0.002);
}

TEST(GirthAtLevel, IsNotFoundWithTwoLevels) {
  EXPECT_FALSE(girth_at_level({{0.01, 1, 0}, {0.02, 1, 0}}, 0, 0.07).found);
  EXPECT_FALSE(girth_at_level(levels(1.0, 1.2), 2.0, 0.07).found);
}

TEST(GirthOfStraightPiece, OfAStraightPieceIsThatOfItsEnd) {
  for (const double hem : {0.9, 1.0, 2.0}) {
    const FittedGirth fit = girth_of_straight_piece(levels(1.0, hem), kHip, 1.0, kLength);
    ASSERT_TRUE(fit.found);
    EXPECT_NEAR(fit.value, hem, 1e-6) << hem;
    EXPECT_NEAR(fit.unseen, (hem - 1.0) * 0.01 / (kLength - kHip), 1e-6);
  }
}

TEST(GirthOfStraightPiece, FoldsThatAreNotSeenIntoAreMadeUpFor) {
  std::vector<LevelGirth> some = levels(1.0, 2.0, 0.002);
  // From two thirds of the way on the scan does not see the folds' depth.
  for (LevelGirth& l : some)
    if (l.t > 0.46) l.girth = std::min(l.girth, 1.6);
  const FittedGirth fit = girth_of_straight_piece(some, kHip, 1.0, kLength);
  ASSERT_TRUE(fit.found);
  EXPECT_NEAR(fit.value, 2.0, 0.1);
  // And what was made up is said.
  EXPECT_GT(fit.unseen, 0.15);
}

TEST(GirthOfStraightPiece, NeedsLevelsBetween) {
  EXPECT_FALSE(girth_of_straight_piece({}, kHip, 1.0, kLength).found);
  EXPECT_FALSE(girth_of_straight_piece({{0.3, 1.1, 0}, {0.4, 1.2, 0}}, kHip, 1.0, kLength).found);
}

}  // namespace
}  // namespace regarment
