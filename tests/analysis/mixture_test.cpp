#include "analysis/mixture.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kZ90 = 1.6448536269514722;  // of the normal distribution, both sides 5 %

TEST(Mixture, OfOneIsItsNormalDistribution) {
  const std::vector<Outcome> one = {{0.7, 0.8, 0.01}};
  EXPECT_NEAR(mixture_quantile(one, 0.5), 0.8, 2e-6);
  EXPECT_NEAR(mixture_quantile(one, 0.95), 0.8 + kZ90 * 0.01, 2e-6);
  EXPECT_NEAR(mixture_quantile(one, 0.05), 0.8 - kZ90 * 0.01, 2e-6);
}

TEST(Mixture, OfEqualsIsOne) {
  const std::vector<Outcome> three = {{0.2, 0.8, 0.01}, {0.3, 0.8, 0.01}, {0.5, 0.8, 0.01}};
  EXPECT_NEAR(mixture_quantile(three, 0.95), 0.8 + kZ90 * 0.01, 2e-6);
}

// Far apart, each outcome holds its own weight: 5 % of all are 10 % of the lower half.
TEST(Mixture, OfTwoFarApartHoldsBoth) {
  const std::vector<Outcome> two = {{0.5, 0.7, 0.01}, {0.5, 0.9, 0.02}};
  constexpr double kZ80 = 1.2815515655446004;  // both sides 10 %
  EXPECT_NEAR(mixture_quantile(two, 0.05), 0.7 - kZ80 * 0.01, 2e-6);
  EXPECT_NEAR(mixture_quantile(two, 0.95), 0.9 + kZ80 * 0.02, 2e-6);
}

TEST(Mixture, LeavesOutWhatIsLessProbableThanTheRest) {
  const std::vector<Outcome> two = {{0.98, 0.7, 0.01}, {0.02, 0.9, 0.01}};
  EXPECT_LT(mixture_quantile(two, 0.95), 0.73);
}

TEST(Mixture, RefusesWhatIsNoDistribution) {
  EXPECT_THROW(mixture_quantile({}, 0.5), InvalidInput);
  EXPECT_THROW(mixture_quantile({{1, 0.8, 0}}, 0.5), InvalidInput);
  EXPECT_THROW(mixture_quantile({{0, 0.8, 0.1}}, 0.5), InvalidInput);
  EXPECT_THROW(mixture_quantile({{1, std::numeric_limits<double>::quiet_NaN(), 0.1}}, 0.5),
               InvalidInput);
  EXPECT_THROW(mixture_quantile({{1, 0.8, 0.1}}, 1), InvalidInput);
}

}  // namespace
}  // namespace regarment
