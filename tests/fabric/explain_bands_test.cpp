#include "fabric/explain_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/error.h"

namespace regarment {
namespace {

// A tube of straight sides, 20 strips: `a` gives the girth at the top, `b` at the bottom.
HoopFamily tube(double girth, const std::function<double(double)>& excess, double fold = 0.02) {
  HoopFamily out;
  out.dimensions = {"a", "b"};
  out.folds = {fold, fold};
  for (int k = 0; k < 20; ++k) {
    const double down = k / 19.0;
    out.bands.push_back({down * 0.4, girth, excess(down), fold, {1 - down, down}});
  }
  return out;
}

constexpr double kError = 0.002;  // m
constexpr StretchPrior kWide = {0.02, 1.0};
constexpr StretchPrior kNearlyNone = {0.0005, 1.0};

TEST(ExplainBands, TellHowFarATopIsStretchedByWhatHangsLooseBelow) {
  // Truly 6 % at the top, gone a quarter of the way down; dimensions as worn hide it, so that the
  // loose strips below seem too short, the more the nearer to the top.
  const auto strain = [](double down) { return 0.06 * std::max(0.0, 1 - 4 * down); };
  const HoopFamily family =
      tube(0.9, [&](double down) { return strain(down) - (1 - down) * 0.06; });
  const std::vector<Stretch> out = explain_bands(family, {kWide, kNearlyNone}, kError);
  EXPECT_NEAR(out[0].mean, 0.06, 0.006);
  EXPECT_LT(out[0].standard_deviation, 0.01);  // of 0.02 before
  EXPECT_NEAR(out[1].mean, 0, 0.003);
}

TEST(ExplainBands, KeepThePriorWhereNothingStandsOut) {
  const HoopFamily family = tube(0.9, [](double) { return 0.0; });
  const std::vector<Stretch> loose = explain_bands(family, {kNearlyNone, kNearlyNone}, kError);
  EXPECT_LT(loose[0].mean, 0.003);
  EXPECT_LT(loose[1].mean, 0.003);
}

TEST(ExplainBands, TakeFoldedClothForLoose) {
  // All strips alike: nothing to compare, but folds at the line itself say that it is loose.
  const auto nothing = [](double) { return 0.0; };
  StretchPrior smooth = kWide, folded = kWide;
  smooth.tight = tight_share(0.001);
  folded.tight = tight_share(0.06);
  const auto tight = explain_bands(tube(0.9, nothing, 0.001), {smooth, smooth}, kError);
  const auto loose = explain_bands(tube(0.9, nothing, 0.06), {folded, folded}, kError);
  EXPECT_GT(tight[0].mean, 0.004);
  EXPECT_LT(loose[0].mean, 0.003);
  EXPECT_LT(loose[0].standard_deviation, tight[0].standard_deviation);
}

TEST(ExplainBands, AreSurerOfAWideTubeThanOfANarrowOne) {
  const auto excess = [](double down) { return -(1 - down) * 0.03; };
  const std::vector<Stretch> trunk = explain_bands(tube(1.0, excess), {kWide, kNearlyNone}, kError);
  const std::vector<Stretch> cuff = explain_bands(tube(0.2, excess), {kWide, kNearlyNone}, kError);
  EXPECT_LT(trunk[0].standard_deviation, cuff[0].standard_deviation);
}

TEST(ExplainBands, SayTheSameTwice) {
  const HoopFamily family = tube(0.5, [](double down) { return 0.01 * down; });
  const auto once = explain_bands(family, {kWide, kWide}, kError);
  const auto twice = explain_bands(family, {kWide, kWide}, kError);
  EXPECT_EQ(once[0].mean, twice[0].mean);
  EXPECT_EQ(once[1].standard_deviation, twice[1].standard_deviation);
}

TEST(ExplainBands, RefuseTooFewPriors) {
  EXPECT_THROW(explain_bands(tube(1, [](double) { return 0.0; }), {kWide}, kError), InvalidInput);
}

}  // namespace
}  // namespace regarment
