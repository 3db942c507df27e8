#include "evaluation/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kExact = 1e-12;

std::vector<Sample> errors(const std::vector<double>& of) {
  std::vector<Sample> out;
  for (const double error : of) out.push_back({50, 50 + error, {}, {}});
  return out;
}

TEST(Statistics, OfNothingAreEmpty) {
  const ErrorStatistics s = error_statistics({});
  EXPECT_EQ(s.n, 0u);
  EXPECT_FALSE(s.sd_cm || s.bias_low_cm || s.slope || s.coverage || s.interval_score_cm);
}

TEST(Statistics, OfOneHaveNoSpread) {
  const ErrorStatistics s = error_statistics(errors({-2}));
  EXPECT_NEAR(s.bias_cm, -2, kExact);
  EXPECT_NEAR(s.worst_cm, 2, kExact);
  EXPECT_NEAR(s.p95_cm, 2, kExact);
  EXPECT_FALSE(s.sd_cm || s.bias_low_cm || s.bias_high_cm);
}

// -3 -1 0 2 7 by hand: sum 5, absolute 13, squares 63, deviations from 1: 16 4 1 1 36.
TEST(Statistics, AgreeWithAnExampleByHand) {
  const ErrorStatistics s = error_statistics(errors({2, -3, 0, 7, -1}));
  EXPECT_EQ(s.n, 5u);
  EXPECT_NEAR(s.bias_cm, 1, kExact);
  EXPECT_NEAR(s.mae_cm, 2.6, kExact);
  EXPECT_NEAR(s.rmse_cm, std::sqrt(63.0 / 5), kExact);
  EXPECT_NEAR(s.median_cm, 0, kExact);
  EXPECT_NEAR(s.worst_cm, 7, kExact);
  EXPECT_NEAR(*s.sd_cm, std::sqrt(58.0 / 4), kExact);
  const double half = 1.96 * std::sqrt(58.0 / 4) / std::sqrt(5.0);
  EXPECT_NEAR(*s.bias_low_cm, 1 - half, kExact);
  EXPECT_NEAR(*s.bias_high_cm, 1 + half, kExact);
  // Sizes 0 1 2 3 7: rank 0.95 * 4 = 3.8 lies 0.8 of the way from 3 to 7.
  EXPECT_NEAR(s.p95_cm, 6.2, kExact);
}

TEST(Statistics, CountTheEndsOfASpanAsWithin) {
  const ErrorStatistics s = error_statistics(errors({1, -1, 1.01, 2, -2.01}));
  EXPECT_NEAR(s.within_1cm, 0.4, kExact);
  EXPECT_NEAR(s.within_2cm, 0.8, kExact);
}

TEST(Statistics, OfTwoHaveTheirMeanAsMedian) {
  EXPECT_NEAR(error_statistics(errors({1, 4})).median_cm, 2.5, kExact);
}

TEST(Statistics, FindTheSlopeOfALine) {
  std::vector<Sample> samples;
  for (const double truth : {40.0, 55.0, 70.0, 100.0}) {
    samples.push_back({truth, 3 + 0.75 * truth, {}, {}});
  }
  EXPECT_NEAR(error_statistics(samples).slope.value(), 0.75, kExact);
}

TEST(Statistics, HaveNoSlopeWithThreeTruths) {
  std::vector<Sample> samples;
  for (const double truth : {40.0, 40.0, 55.0, 55.0, 70.0})
    samples.push_back({truth, truth, {}, {}});
  EXPECT_FALSE(error_statistics(samples).slope);
}

TEST(Statistics, AreTheSameForMovedSamplesButBias) {
  std::vector<Sample> samples = errors({0.4, -1.2, 3.1, 0.9});
  const ErrorStatistics before = error_statistics(samples);
  for (Sample& sample : samples) sample.estimate += 5;
  const ErrorStatistics after = error_statistics(samples);
  EXPECT_NEAR(after.bias_cm, before.bias_cm + 5, kExact);
  EXPECT_NEAR(*after.sd_cm, *before.sd_cm, kExact);
}

TEST(Statistics, CountOnlyIntervalsThatAreThere) {
  const std::vector<Sample> samples = {{10, 10, 9.0, 11.0},   // width 2, holds
                                       {10, 12, 10.0, 14.0},  // width 4, its end counts
                                       {10, 13, 12.0, 14.0},  // width 2, missed by 2
                                       {10, 10, {}, {}}};
  const ErrorStatistics s = error_statistics(samples);
  EXPECT_EQ(s.intervals, 3u);
  EXPECT_NEAR(s.coverage.value(), 2.0 / 3, kExact);
  EXPECT_NEAR(s.median_width_cm.value(), 2, kExact);
  EXPECT_NEAR(s.interval_score_cm.value(), (2 + 4 + (2 + 20 * 2)) / 3.0, kExact);
}

TEST(IntervalScore, AddsTwentyTimesWhatIsBeyondEitherEnd) {
  EXPECT_NEAR(interval_score(4, 6, 5), 2, kExact);
  EXPECT_NEAR(interval_score(4, 6, 3.5), 2 + 10, kExact);
  EXPECT_NEAR(interval_score(4, 6, 6.5), 2 + 10, kExact);
}

// The quantiles at 5 and 95 % make the mean score smallest: it cannot be gamed by width.
TEST(IntervalScore, IsBestForTheTrueQuantiles) {
  const auto mean_score = [](double half) {
    double sum = 0;
    for (int i = 0; i < 2000; ++i) sum += interval_score(-half, half, -1 + (i + 0.5) / 1000);
    return sum / 2000;
  };
  EXPECT_LT(mean_score(0.9), mean_score(0.8));
  EXPECT_LT(mean_score(0.9), mean_score(1.0));
}

TEST(Quantile, LiesBetweenRanks) {
  EXPECT_NEAR(quantile({4, 1, 3, 2}, 0.5), 2.5, kExact);
  EXPECT_NEAR(quantile({4, 1, 3, 2}, 0), 1, kExact);
  EXPECT_NEAR(quantile({4, 1, 3, 2}, 1), 4, kExact);
  EXPECT_THROW(quantile({}, 0.5), InvalidInput);
}

}  // namespace
}  // namespace regarment
