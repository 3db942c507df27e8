#include "base/random.h"

#include <gtest/gtest.h>

#include <set>

namespace regarment {
namespace {

constexpr int kDraws = 200'000;

TEST(Random, IsTheMersenneTwisterOfAMixedSeed) {
  // The standard fixes the engine and the mixing, so these numbers are the same everywhere.
  std::seed_seq mixed{0x89abcdefU, 0x01234567U, 3U};
  std::mt19937_64 engine(mixed);
  Random random(0x0123456789abcdefULL, 3);
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(random.uniform(), std::ldexp(static_cast<double>(engine() >> 11U), -53));
}

TEST(Random, IsUniformInItsRange) {
  Random random(1);
  double sum = 0, squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform(-2, 6);
    ASSERT_GE(u, -2);
    ASSERT_LT(u, 6);
    sum += u;
    squares += (u - 2) * (u - 2);
  }
  // Five standard errors of the mean and of the variance 64 / 12.
  EXPECT_NEAR(sum / kDraws, 2, 5 * std::sqrt(64.0 / 12 / kDraws));
  EXPECT_NEAR(squares / kDraws, 64.0 / 12, 5 * std::sqrt((256.0 / 5 - 256.0 / 9) / kDraws));
}

TEST(Random, IsNormalWithMeanZeroAndDeviationOne) {
  Random random(2);
  double sum = 0, squares = 0;
  int within_one = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    ASSERT_TRUE(std::isfinite(x));
    sum += x;
    squares += x * x;
    within_one += std::abs(x) < 1;
  }
  EXPECT_NEAR(sum / kDraws, 0, 5 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(static_cast<double>(within_one) / kDraws, std::erf(1 / std::sqrt(2)),
              5 * std::sqrt(0.25 / kDraws));
}

TEST(Random, StreamsAndSeedsDifferAndCopiesAgree) {
  std::set<double> first;
  for (const std::uint64_t seed : {0ULL, 1ULL, 1ULL << 32U, ~0ULL})
    for (const std::uint32_t stream : {0U, 1U, 2U}) first.insert(Random(seed, stream).uniform());
  EXPECT_EQ(first.size(), 12U);

  Random one(7), other(7, 1);
  double product = 0;
  for (int i = 0; i < kDraws; ++i) product += (one.uniform() - 0.5) * (other.uniform() - 0.5);
  EXPECT_NEAR(product / kDraws, 0, 5 / (12 * std::sqrt(kDraws)));  // no correlation

  Random copy = one;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(copy.uniform(), one.uniform());
}

}  // namespace
}  // namespace regarment
