#include "fit/weights.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "fit/error_terms.h"

namespace regarment {
namespace {

TEST(Balance, BringsTheMediansToThatOfTheDistance) {
  // Medians: distance 0.02, |1 - stretch| 0.09 with the root 0.3, silhouette 0.5.
  const std::vector<ErrorTerms> samples = {
      {0.01, 1.04, 8.0}, {0.03, 0.91, 0.25}, {0.02, 1.25, 0.5}};
  const ErrorWeights weights = balance(samples);
  EXPECT_EQ(weights.alpha, 1);
  EXPECT_DOUBLE_EQ(weights.beta, 0.02 / 0.3);
  EXPECT_DOUBLE_EQ(weights.gamma, 0.02 / 0.5);
  EXPECT_DOUBLE_EQ(balance(samples, false).beta, 0.02 / 0.09);
}

TEST(Balance, MakesTheTermsOfAMiddlingSampleEqual) {
  const ErrorTerms middling{0.015, 0.96, 0.75};
  const std::vector<ErrorTerms> samples = {middling, {0.001, 0.999, 9}, {0.5, 0.5, 0.001}};
  const auto [alpha, beta, gamma] = balance(samples);
  EXPECT_NEAR(total_error(middling, {alpha, 0, 0}), 0.015, 1e-15);
  EXPECT_NEAR(total_error(middling, {0, beta, 0}), 0.015, 1e-15);
  EXPECT_NEAR(total_error(middling, {0, 0, gamma}), 0.015, 1e-15);
}

TEST(Balance, IsNotLedByAFewWildSamples) {
  std::vector<ErrorTerms> samples(5, ErrorTerms{0.02, 1.04, 0.4});
  const ErrorWeights usual = balance(samples);
  samples[1] = samples[4] = {1e3, 1e6, 1e9};
  const ErrorWeights wild = balance(samples);
  EXPECT_EQ(usual.beta, wild.beta);
  EXPECT_EQ(usual.gamma, wild.gamma);
}

TEST(Balance, TheOrderOfTheSamplesDoesNotMatter) {
  std::vector<ErrorTerms> samples = {{0.01, 1.04, 2.0}, {0.03, 0.91, 0.5}, {0.02, 1.25, 1.0}};
  const ErrorWeights forwards = balance(samples);
  std::swap(samples[0], samples[2]);
  const ErrorWeights backwards = balance(samples);
  EXPECT_EQ(forwards.beta, backwards.beta);
  EXPECT_EQ(forwards.gamma, backwards.gamma);
}

TEST(Balance, ATermThatIsZeroIsWeighedAsAHundredth) {
  const ErrorWeights weights = balance(std::vector<ErrorTerms>{{0.02, 1, 0}});
  EXPECT_DOUBLE_EQ(weights.beta, 0.02 / std::sqrt(0.01));
  EXPECT_DOUBLE_EQ(weights.gamma, 0.02 / 0.01);
}

TEST(Balance, WeightsArePositiveAndFiniteWhereAllTermsAreZero) {
  const ErrorWeights weights = balance(std::vector<ErrorTerms>{{0, 1, 0}, {0, 1, 0}});
  EXPECT_EQ(weights.alpha, 1);
  for (const double weight : {weights.beta, weights.gamma}) {
    EXPECT_TRUE(std::isfinite(weight));
    EXPECT_GT(weight, 0);
  }
}

TEST(Balance, RefusesNoSamples) { EXPECT_THROW(balance({}), InvalidInput); }

}  // namespace
}  // namespace regarment
