#include "optim/annealed_simplex.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/error.h"
#include "test_functions.h"

namespace regarment {
namespace {

using test::Search;
using test::Searched;
using test::vec;
using test::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Search without_temperature(const VectorXd& start, const VectorXd& edges, int evaluations) {
  Search search{start, edges, {}};
  search.options.start_temperature = 0;
  search.options.max_evaluations = evaluations;
  return search;
}

void expect_trials(const Searched& searched, const std::vector<VectorXd>& by_hand) {
  ASSERT_GE(searched.steps.size(), by_hand.size());
  for (std::size_t i = 0; i < by_hand.size(); ++i)
    EXPECT_EQ(searched.steps[i].at, by_hand[i]) << "evaluation " << i + 1;
}

// The corners (0,0), (1,0), (0,1) with the values 3, 2, 1: the first is the worst, the centre of
// the others (1/2, 1/2).
double plane(const VectorXd& x) { return 3 - x[0] - 2 * x[1]; }

TEST(NelderMead, ReflectsThenExpandsWhileItGetsBetter) {
  // (1,1) is better than all, (3/2, 3/2) better still. Then (1,0) is the worst, with the value 2
  // against 1 and -3/2: the centre is (3/4, 5/4).
  expect_trials(
      without_temperature(vec({0, 0}), vec({1, 1}), 20).of(plane),
      {vec({0, 0}), vec({1, 0}), vec({0, 1}), vec({1, 1}), vec({1.5, 1.5}), vec({0.5, 2.5})});
}

TEST(NelderMead, KeepsTheReflectedPointWhenTheExpandedOneIsWorse) {
  const auto wall = [](const VectorXd& x) { return x[0] > 1.2 ? 10 : plane(x); };
  // (1,1) is kept instead of (3/2, 3/2); the worst is then (1,0), the centre (1/2, 1).
  expect_trials(without_temperature(vec({0, 0}), vec({1, 1}), 20).of(wall),
                {vec({0, 0}), vec({1, 0}), vec({0, 1}), vec({1, 1}), vec({1.5, 1.5}), vec({0, 2})});
}

TEST(NelderMead, ContractsOutsideInsideAndAtLastShrinks) {
  std::vector<double> values = {3, 2, 1, 2.5, 2.6, 9, 9, 9};
  std::size_t next = 0;
  const auto listed = [&](const VectorXd&) { return values[std::min(next++, values.size() - 1)]; };
  // Reflected (1,1) has 2.5, between second worst and worst: contract outside to (3/4, 3/4).
  // Its 2.6 is no better than 2.5: shrink towards (0,1).
  expect_trials(without_temperature(vec({0, 0}), vec({1, 1}), 20).of(listed),
                {vec({0, 0}), vec({1, 0}), vec({0, 1}), vec({1, 1}), vec({0.75, 0.75}),
                 vec({0, 0.5}), vec({0.5, 0.5})});
  values = {3, 2, 1, 4, 2.9, 9, 9};
  next = 0;
  // Reflected (1,1) is the worst of all: contract inside to (1/4, 1/4), better than 3: kept and
  // still the worst. The next goes from it through (1/2, 1/2).
  expect_trials(
      without_temperature(vec({0, 0}), vec({1, 1}), 20).of(listed),
      {vec({0, 0}), vec({1, 0}), vec({0, 1}), vec({1, 1}), vec({0.25, 0.25}), vec({0.75, 0.75})});
}

TEST(NelderMead, FindsTheEndOfRosenbrocksValley) {
  for (const int n : {2, 4}) {
    Search search = without_temperature(VectorXd::Constant(n, -1.2), VectorXd::Constant(n, 0.5),
                                        n == 2 ? 600 : 3000);
    search.options.value_tolerance = 1e-12;
    search.options.position_tolerance = 1e-6;
    const SearchResult found = search.of(test::rosenbrock).result;
    EXPECT_EQ(found.ending, SearchEnding::Converged) << n;
    // Along the valley the value grows as the squared distance: 1e-12 of the first spread, below
    // 1e4, leaves 1e-4.
    EXPECT_LT((found.at - VectorXd::Ones(n)).norm(), 1e-4) << n;
  }
}

TEST(NelderMead, FindsPowellsSingularMinimum) {
  Search search = without_temperature(vec({3, -1, 0, 1}), VectorXd::Constant(4, 1), 3000);
  search.options.value_tolerance = 1e-12;
  search.options.position_tolerance = 1e-6;
  const SearchResult found = search.of(test::powell).result;
  // The value grows with the fourth power of the distance: 1e-10 leaves some 1e-2.5.
  EXPECT_LT(found.value, 1e-10);
  EXPECT_LT(found.at.norm(), 0.01);
}

TEST(NelderMead, EndsInAMinimumOfHimmelblausFunction) {
  for (const VectorXd& start : {vec({0, 0}), vec({-4, 4}), vec({-4, -4}), vec({4, -4})}) {
    const SearchResult found =
        without_temperature(start, vec({1, 1}), 300).of(test::himmelblau).result;
    EXPECT_EQ(found.ending, SearchEnding::Converged);
    double nearest = kInfinity;
    for (const VectorXd& m : test::himmelblau_minima())
      nearest = std::min(nearest, (found.at - m).norm());
    EXPECT_LT(nearest, 0.01) << start.transpose();
  }
}

TEST(AnnealedSimplex, SearchesOneDimensionToo) {
  Search search{vec({4}), vec({1}), {}};
  search.low = 0;
  search.high = 10;
  const auto parabola = [](const VectorXd& x) { return std::pow(x[0] - 7.25, 2); };
  EXPECT_NEAR(search.of(parabola).result.at[0], 7.25, 0.01);
}

TEST(AnnealedSimplex, EvaluatesInsideTheBoxOnly) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Search search{vec({0.9, -1, 1}), vec({0.5, -0.5, 5}), {}, -1, 1};
    // The smallest value lies outside, the third edge is wider than the box.
    const auto f = [](const VectorXd& x) { return (x - vec({3, 0.2, -4})).squaredNorm(); };
    const Searched searched = search.of(f, seed);
    for (const auto& step : searched.steps)
      ASSERT_LE(step.at.cwiseAbs().maxCoeff(), 1) << "evaluation " << step.evaluation;
    EXPECT_EQ(searched.steps[1].at, vec({0.4, -1, 1}));
    EXPECT_EQ(searched.steps[2].at, vec({0.9, -0.5, 1}));
    EXPECT_EQ(searched.steps[3].at, vec({0.9, -1, -1}));
    EXPECT_LT((searched.result.at - vec({1, 0.2, -1})).norm(), 0.01) << seed;
  }
}

TEST(AnnealedSimplex, NeverEvaluatesMoreThanAllowed) {
  for (int allowed = 4; allowed < 60; ++allowed) {
    Search search{vec({-1.2, 1}), vec({0.5, 0.5}), {}};
    search.options.max_evaluations = allowed;
    int calls = 0;
    const Searched searched = search.of([&](const VectorXd& x) {
      ++calls;
      return test::rosenbrock(x);
    });
    EXPECT_EQ(calls, allowed);
    EXPECT_EQ(searched.result.evaluations, allowed);
    EXPECT_EQ(searched.steps.size(), std::size_t(allowed));
    EXPECT_EQ(searched.result.ending, SearchEnding::EvaluationLimit);
  }
}

TEST(AnnealedSimplex, TellsEachStepAndKeepsTheBest) {
  Search search{vec({-1.2, 1}), vec({0.5, 0.5}), {}};
  const Searched searched = search.of(test::rosenbrock);
  double best = kInfinity;
  VectorXd at;
  for (std::size_t i = 0; i < searched.steps.size(); ++i) {
    const SearchStep& step = searched.steps[i];
    EXPECT_EQ(step.evaluation, int(i) + 1);
    EXPECT_EQ(step.value, test::rosenbrock(step.at));
    if (step.value < best) at = step.at, best = step.value;
    EXPECT_EQ(step.best, best);
  }
  EXPECT_EQ(searched.result.value, best);
  EXPECT_EQ(searched.result.at, at);
}

TEST(AnnealedSimplex, SurvivesValuesThatAreNotFinite) {
  // A function with values on a half plane only, and holes in that.
  const auto holed = [](const VectorXd& x) {
    if (x[0] < 0) return -kInfinity;
    if (std::sin(40 * x[0]) > 0.9) return std::nan("");
    return test::himmelblau(x);
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Search search{vec({0.5, 0.5}), vec({-1, 1}), {}, -6, 6};
    const Searched searched = search.of(holed, seed);
    EXPECT_LT(searched.result.value, 1) << seed;
    EXPECT_GE(searched.result.at[0], 0);
    EXPECT_EQ(searched.steps[1].value, kInfinity);
  }
  Search search{vec({0.5, 0.5}), vec({1, 1}), {}};
  const SearchResult nowhere = search.of([](const VectorXd&) { return std::nan(""); }).result;
  EXPECT_EQ(nowhere.value, kInfinity);
  EXPECT_EQ(nowhere.at, search.start);
  EXPECT_EQ(nowhere.ending, SearchEnding::EvaluationLimit);
  const auto huge = [](const VectorXd& x) { return x[0] > 0.7 ? 1.7e308 : -1.7e308; };
  EXPECT_EQ(search.of(huge).result.value, -1.7e308);
}

TEST(AnnealedSimplex, LetsExceptionsThrough) {
  struct Enough : std::runtime_error {
    Enough() : std::runtime_error("enough") {}
  };
  const Search search{vec({0, 0}), vec({1, 1}), {}};
  const auto f = [](const VectorXd& x) -> double {
    return x[0] > 0.9 ? throw Enough() : test::himmelblau(x);
  };
  EXPECT_THROW(search.of(f), Enough);
  Random random(1);
  const VectorXd wide = VectorXd::Constant(2, 10);
  int told = 0;
  EXPECT_THROW(
      minimize_annealed(test::himmelblau, search.start, search.edges, -wide, wide, {}, random,
                        [&](const SearchStep&) {
                          if (++told == 40) throw Enough();
                        }),
      Enough);
  EXPECT_EQ(told, 40);
}

TEST(AnnealedSimplex, RefusesWhatIsNoSearch) {
  const Search good{vec({0, 0}), vec({1, 1}), {}, -2, 2};
  const auto refused = [&](auto change) {
    Search search = good;
    change(search);
    EXPECT_THROW(search.of(test::himmelblau), InvalidInput);
  };
  EXPECT_NO_THROW(good.of(test::himmelblau));
  refused([](Search& s) { s.start = s.edges = VectorXd(); });
  refused([](Search& s) { s.edges = vec({1, 1, 1}); });
  refused([](Search& s) { s.start = vec({0, 2.1}); });
  refused([](Search& s) { s.start = vec({std::nan(""), 0}); });
  refused([](Search& s) { s.edges = vec({1, 0}); });
  refused([](Search& s) { s.edges = vec({kInfinity, 1}); });
  refused([](Search& s) { s.high = -2; });
  refused([](Search& s) { s.low = std::nan(""); });
  refused([](Search& s) { s.options.max_evaluations = 3; });
  refused([](Search& s) { s.options.start_temperature = -0.1; });
  refused([](Search& s) { s.options.start_temperature = std::nan(""); });
  refused([](Search& s) { s.options.cooling_exponent = 0; });
  refused([](Search& s) { s.options.cooling_share = 1.1; });
  refused([](Search& s) { s.options.value_tolerance = -1; });
  refused([](Search& s) { s.options.position_tolerance = kInfinity; });
}

}  // namespace
}  // namespace regarment
