// What temperature brings: other valleys than the nearest one, also under noise.
#include <gtest/gtest.h>

#include "test_functions.h"

namespace regarment {
namespace {

using test::Search;
using test::Searched;
using test::vec;
using test::VectorXd;

constexpr int kSeeds = 50;

// Uneven ground on a bowl, smallest at 0; valleys lie one apart, and the ground rises by 10 from
// valley to hill.
double rastrigin(const VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    sum += x[i] * x[i] + 5 * (1 - std::cos(2 * std::numbers::pi * x[i]));
  return sum;
}

int found_the_lowest_valley(const Search& search) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random noise(seed, 7);
    const auto noisy = [&](const VectorXd& x) { return rastrigin(x) + 0.2 * noise.normal(); };
    found += search.of(noisy, seed).result.at.cwiseAbs().maxCoeff() < 0.5;
  }
  return found;
}

TEST(Annealing, FindsTheLowestOfManyNoisyValleys) {
  Search search{vec({3.2, -2.9}), vec({1.3, 1.3}), {}, -5, 5};
  search.options.max_evaluations = 4000;
  search.options.start_temperature = 0.5;
  const int warm = found_the_lowest_valley(search);
  search.options.start_temperature = 0;
  const int cold = found_the_lowest_valley(search);
  EXPECT_GE(warm, 0.75 * kSeeds);
  EXPECT_LE(cold, 0.1 * kSeeds);
}

TEST(Annealing, ReachesSeveralOfHimmelblausMinima) {
  Search search{vec({0, 0}), vec({2, 2}), {}, -6, 6};
  search.options.max_evaluations = 600;
  std::vector<int> visits(4, 0);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const SearchResult found = search.of(test::himmelblau, seed).result;
    for (std::size_t k = 0; k < 4; ++k)
      visits[k] += (found.at - test::himmelblau_minima()[k]).norm() < 0.02;
  }
  EXPECT_EQ(visits[0] + visits[1] + visits[2] + visits[3], kSeeds);
  EXPECT_GE(std::count_if(visits.begin(), visits.end(), [](int n) { return n > 0; }), 2);
}

TEST(Annealing, FindsTheLowestValleyOfATiltedHimmelblau) {
  // The tilt leaves the valley near (-3.8, -3.3) the lowest; a cold search from (3, 2.5) ends
  // beside it at (3, 2).
  const auto tilted = [](const VectorXd& x) { return test::himmelblau(x) + 5 * (x[0] + x[1]); };
  Search search{vec({3, 2.5}), vec({2, 2}), {}, -6, 6};
  search.options.max_evaluations = 2000;
  search.options.start_temperature = 1;
  const auto found = [&] {
    int count = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
      count += (search.of(tilted, seed).result.at - vec({-3.8, -3.3})).norm() < 0.5;
    return count;
  };
  EXPECT_GE(found(), 0.75 * kSeeds);
  search.options.start_temperature = 0;
  EXPECT_EQ(found(), 0);
}

TEST(Annealing, CoolsAsTheOptionsSay) {
  Search search{vec({-1.2, 1}), vec({0.5, 0.5}), {}};
  search.options.max_evaluations = 200;
  search.options.start_temperature = 0.25;
  search.options.cooling_exponent = 3;
  search.options.cooling_share = 0.8;
  const Searched searched = search.of(test::rosenbrock);
  const auto [low, high] = std::minmax_element(
      searched.steps.begin(), searched.steps.begin() + 3,
      [](const SearchStep& a, const SearchStep& b) { return a.value < b.value; });
  const double t0 = 0.25 * (high->value - low->value);
  int warm = 0;
  for (const SearchStep& step : searched.steps) {
    if (step.temperature == 0) continue;
    ++warm;
    // The temperature is that at the beginning of its move, of at most 4 evaluations.
    const auto cooled = [&](int k) { return t0 * std::pow(std::max(0.0, 1 - k / 160.0), 3); };
    EXPECT_LE(step.temperature, cooled(step.evaluation - 4)) << step.evaluation;
    EXPECT_GE(step.temperature, cooled(step.evaluation)) << step.evaluation;
    EXPECT_GT(step.evaluation, 3);
    EXPECT_LE(step.evaluation, 160 + 4);
  }
  EXPECT_GT(warm, 120);  // all but the corners of new simplices
}

TEST(Annealing, MakesEachNewSimplexRoundOnePoint) {
  Search search{vec({3.2, -2.9}), vec({1.3, 1.3}), {}, -5, 5};
  search.options.max_evaluations = 1000;
  int simplices = 0, better = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::vector<SearchStep> steps = search.of(rastrigin, seed).steps;
    // While it is warm, only corners of new simplices have no temperature.
    for (std::size_t i = 3; i < 650;) {
      if (steps[i].temperature > 0) {
        ++i;
        continue;
      }
      ++simplices;
      EXPECT_EQ(steps[i].value, steps[i - 1].best);  // the best point, measured again
      better += steps[i + 1].best < steps[i].best;
      for (std::size_t corner = 0; corner < 2; ++corner) {
        const VectorXd edge = steps[i + 1 + corner].at - steps[i].at;
        ASSERT_NEAR(std::abs(edge[Eigen::Index(corner)]), 1.3, 1e-12);
        ASSERT_EQ(edge[Eigen::Index(1 - corner)], 0);
      }
      i += 3;
    }
  }
  EXPECT_GT(simplices, 2 * kSeeds);
  EXPECT_GT(better, 0);  // also when the first new corner is the new best point
}

TEST(Annealing, TakesTheSameStepsForTheSameSeedOnly) {
  const Search search{vec({-1.2, 1}), vec({0.5, 0.5}), {}};
  const Searched first = search.of(test::rosenbrock, 5);
  EXPECT_TRUE(same_steps(first, search.of(test::rosenbrock, 5)));
  EXPECT_FALSE(same_steps(first, search.of(test::rosenbrock, 6)));
  Search cold = search;
  cold.options.start_temperature = 0;
  EXPECT_TRUE(same_steps(cold.of(test::rosenbrock, 5), cold.of(test::rosenbrock, 6)));
}

TEST(Annealing, DoesNotCareForAConstantOrAFactor) {
  const Search search{vec({-1.2, 1}), vec({0.5, 0.5}), {}};
  // Values in steps of 2^-20 below 2^20 take a constant and a power of two without rounding.
  const auto stepped = [](const VectorXd& x) {
    return std::min(std::ldexp(std::round(std::ldexp(test::rosenbrock(x), 20)), -20), 1e6);
  };
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Searched plain = search.of(stepped, seed);
    EXPECT_TRUE(
        same_steps(plain, search.of([&](const VectorXd& x) { return stepped(x) - 1024; }, seed)));
    EXPECT_TRUE(
        same_steps(plain, search.of([&](const VectorXd& x) { return 8 * stepped(x); }, seed)));
  }
}

}  // namespace
}  // namespace regarment
