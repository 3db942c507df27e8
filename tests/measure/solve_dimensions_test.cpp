#include <gtest/gtest.h>

#include "base/error.h"
#include "garment/find_template.h"
#include "measure/observe.h"
#include "support/dice.h"

namespace regarment {
namespace {

using test::Dice;

/// Dimensions anywhere inside the bounds that together make a garment.
Dimensions random_dimensions(const GarmentTemplate& garment, Dice& dice) {
  while (true) {
    Dimensions at;
    for (const Dimension& d : garment.dimensions()) {
      const double margin = 0.05 * (d.upper - d.lower);
      at[d.name] = dice.uniform(d.lower + margin, d.upper - margin);
    }
    try {
      garment.check(at);
      return at;
    } catch (const UsageError&) {
      continue;
    }
  }
}

std::vector<ObservedLength> observed_at(const GarmentTemplate& garment, const Dimensions& at,
                                        double deviation) {
  std::vector<ObservedLength> out;
  for (const Observation& o : garment.observations())
    out.push_back({&o, garment.evaluate(o.equals, at), deviation, true});
  return out;
}

class SolveDimensions : public testing::TestWithParam<const char*> {};

TEST_P(SolveDimensions, RecoversTheDimensionsThatMadeTheObservations) {
  const GarmentTemplate garment = find_template(GetParam());
  Dice dice(41);
  for (int k = 0; k < 50; ++k) {
    const Dimensions truth = random_dimensions(garment, dice);
    const auto solved = solve_dimensions(garment, observed_at(garment, truth, 0.005));
    ASSERT_EQ(solved.size(), truth.size());
    for (const auto& [name, value] : truth) {
      EXPECT_NEAR(solved.at(name).value, value, 1e-5) << name << " in round " << k;
      EXPECT_TRUE(solved.at(name).observable) << name;
      EXPECT_GT(solved.at(name).standard_deviation, 0) << name;
    }
  }
}

TEST_P(SolveDimensions, WithoutObservationsNothingIsObservable) {
  const GarmentTemplate garment = find_template(GetParam());
  std::vector<ObservedLength> observed = observed_at(garment, garment.typical(), 0.005);
  for (ObservedLength& o : observed) o.seen = false, o.value = 1e6;
  for (const auto& none : {observed, std::vector<ObservedLength>{}}) {
    for (const auto& [name, solved] : solve_dimensions(garment, none)) {
      EXPECT_FALSE(solved.observable) << name;
      EXPECT_DOUBLE_EQ(solved.value, garment.typical().at(name)) << name;
      // As unsure as the bounds are wide.
      const Dimension& d = garment.dimension(name);
      EXPECT_GT(solved.standard_deviation, 0.2 * (d.upper - d.lower)) << name;
    }
  }
}

TEST_P(SolveDimensions, DeviationsScaleWithThoseOfTheObservations) {
  const GarmentTemplate garment = find_template(GetParam());
  const auto once = solve_dimensions(garment, observed_at(garment, garment.typical(), 0.002));
  const auto thrice = solve_dimensions(garment, observed_at(garment, garment.typical(), 0.006));
  for (const auto& [name, solved] : once)
    EXPECT_NEAR(thrice.at(name).standard_deviation, 3 * solved.standard_deviation,
                0.01 * solved.standard_deviation)
        << name;
}

TEST_P(SolveDimensions, FitsTheOthersAroundWhatIsFixed) {
  const GarmentTemplate garment = find_template(GetParam());
  Dice dice(43);
  for (int k = 0; k < 20; ++k) {
    const Dimensions truth = random_dimensions(garment, dice);
    const std::string& name = garment.dimensions()[k % garment.dimensions().size()].name;
    // The truth held is the truth found, also of what was not seen.
    auto solved =
        solve_dimensions(garment, observed_at(garment, truth, 0.005), {{name, truth.at(name)}});
    for (const auto& [other, value] : truth) EXPECT_NEAR(solved.at(other).value, value, 1e-5);
    // Something else held stays what it is, whatever was seen.
    const Dimension& d = garment.dimension(name);
    const double held = 0.5 * (d.lower + d.upper);
    solved = solve_dimensions(garment, observed_at(garment, truth, 0.005), {{name, held}});
    EXPECT_EQ(solved.at(name).value, held);
    EXPECT_EQ(solved.at(name).standard_deviation, 0);
    EXPECT_TRUE(solved.at(name).observable);
  }
}

TEST_P(SolveDimensions, StaysWithinTheBounds) {
  const GarmentTemplate garment = find_template(GetParam());
  for (const double scale : {0.05, 20.0}) {
    std::vector<ObservedLength> observed = observed_at(garment, garment.typical(), 0.005);
    for (ObservedLength& o : observed) o.value *= scale;
    for (const auto& [name, solved] : solve_dimensions(garment, observed)) {
      EXPECT_GE(solved.value, garment.dimension(name).lower) << name;
      EXPECT_LE(solved.value, garment.dimension(name).upper) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, SolveDimensions, testing::Values("skirt", "tshirt"),
                         [](const auto& name) { return std::string(name.param); });

TEST(SolveSkirt, AnUnseenLengthLeavesItsDimensionOpenAndTheOthersExact) {
  const GarmentTemplate skirt = find_template("skirt");
  Dice dice(42);
  for (const std::string hidden : {"length", "width", "waist", "hip"}) {
    const Dimensions truth = random_dimensions(skirt, dice);
    std::vector<ObservedLength> observed = observed_at(skirt, truth, 0.005);
    for (ObservedLength& o : observed)
      if (o.observation->equals == hidden) o.seen = false;
    const auto solved = solve_dimensions(skirt, observed);
    for (const auto& [name, value] : truth) {
      EXPECT_EQ(solved.at(name).observable, name != hidden) << name;
      EXPECT_NEAR(solved.at(name).value, name == hidden ? skirt.typical().at(name) : value, 1e-6)
          << name;
    }
  }
}

TEST(SolveTshirt, TwoObservationsOfOneLengthAreWeighedByTheirDeviations) {
  const GarmentTemplate tshirt = find_template("tshirt");
  std::vector<ObservedLength> observed = observed_at(tshirt, tshirt.typical(), 0.004);
  int cuffs = 0;
  for (ObservedLength& o : observed) {
    if (o.observation->equals != "sleeve_opening") continue;
    o.value = cuffs == 0 ? 0.40 : 0.43;
    o.standard_deviation = cuffs++ == 0 ? 0.004 : 0.008;
  }
  ASSERT_EQ(cuffs, 2);
  // Weights 4 : 1; the deviation of the mean is 1 / sqrt(1 / 0.004^2 + 1 / 0.008^2).
  const SolvedDimension opening = solve_dimensions(tshirt, observed).at("sleeve_opening");
  EXPECT_NEAR(opening.value, 0.40 + 0.03 / 5, 1e-4);
  EXPECT_NEAR(opening.standard_deviation, 1 / std::sqrt(1 / 0.000016 + 1 / 0.000064), 1e-5);
}

TEST(SolveTshirt, SleeveLengthFollowsFromUpperEdgeAndWidth) {
  // By hand: at width 100 cm the shoulder's half width is 21.5 cm, so the shoulder runs 12.5 cm
  // across and 12.5 / cos 20 degrees along; the rest of an upper edge of 40 cm is sleeve.
  const GarmentTemplate tshirt = find_template("tshirt");
  Dimensions at = tshirt.typical();
  at["width"] = 1.0;
  std::vector<ObservedLength> observed = observed_at(tshirt, at, 0.004);
  for (ObservedLength& o : observed)
    if (o.observation->side == "top") o.value = 0.40;
  const double expected = 0.40 - 0.125 / std::cos(20 * std::numbers::pi / 180);
  EXPECT_NEAR(solve_dimensions(tshirt, observed).at("sleeve_length").value, expected, 1e-5);
}

}  // namespace
}  // namespace regarment
