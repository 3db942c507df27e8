#include "fabric/posterior_sample.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regarment {
namespace {

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments(const std::vector<std::vector<double>>& draws, std::size_t variable) {
  double first = 0, second = 0;
  const auto n = static_cast<double>(draws.size());
  for (const std::vector<double>& draw : draws) {
    first += draw[variable] / n;
    second += draw[variable] * draw[variable] / n;
  }
  return {first, std::sqrt(second - first * first)};
}

TEST(PosteriorSample, IsStandardNormalWithoutEvidence) {
  const auto draws = posterior_sample(2, [](const std::vector<double>&) { return 0.0; });
  // Six hundred draws: a mean errs by 0.04, a deviation by 0.03.
  for (const std::size_t variable : {0U, 1U}) {
    EXPECT_NEAR(moments(draws, variable).mean, 0, 0.15);
    EXPECT_NEAR(moments(draws, variable).deviation, 1, 0.12);
  }
}

TEST(PosteriorSample, MeetsTheClosedFormOfANormalObservation) {
  // x observed as 3 with deviation 0.5: mean 3 / (1 + 0.25), deviation sqrt(0.25 / 1.25).
  const auto draws = posterior_sample(
      2, [](const std::vector<double>& x) { return -0.5 * std::pow((x[0] - 3) / 0.5, 2); });
  EXPECT_NEAR(moments(draws, 0).mean, 2.4, 0.08);
  EXPECT_NEAR(moments(draws, 0).deviation, std::sqrt(0.2), 0.08);
  EXPECT_NEAR(moments(draws, 1).deviation, 1, 0.12);
}

TEST(PosteriorSample, FindsBothOfTwoPeaks) {
  const auto draws = posterior_sample(1, [](const std::vector<double>& x) {
    return std::log(std::exp(-50 * std::pow(x[0] - 1.5, 2)) +
                    std::exp(-50 * std::pow(x[0] + 1.5, 2)) + 1e-30);
  });
  int right = 0;
  for (const auto& draw : draws) {
    EXPECT_GT(std::abs(draw[0]), 0.9);
    right += draw[0] > 0 ? 1 : 0;
  }
  EXPECT_NEAR(right / static_cast<double>(draws.size()), 0.5, 0.15);
}

}  // namespace
}  // namespace regarment
