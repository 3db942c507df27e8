#include "measure/edge_finder.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/limbs.h"

namespace regarment {
namespace {

using test::LimbPlan;

constexpr double kPi = std::numbers::pi;
constexpr double kCloth = 0.004;  // m
// Mean error allowed, m. A sharp edge just between two rows shows as well one row further on, since
// the rows next to an edge are left out: half a row of 4 mm is the least a search by rows can
// promise.
constexpr double kHalfRow = 0.002 + 1e-9;

/// A garment on a limb whose edge waves round it.
struct StepPlan {
  const char* name;
  bool garment_above = true;
  double slope = 0;  // m of radius per m of height
  double wave = 0;   // m, amplitude of cos 2 phi
  double tilt = 0;   // m, amplitude of cos phi
  double noise = 0;  // m
  double holes = 0;  // share of the angle without data
  double at = 0.7;   // m, mean height of the edge

  double edge(double phi) const {
    return at + wave * std::cos(2 * phi) + tilt * std::cos(phi - 0.7);
  }
  LimbPlan limb() const {
    LimbPlan plan;
    plan.radius = [*this](double s, double phi) {
      const bool cloth = garment_above ? s > edge(phi) : s < edge(phi);
      return 0.16 + slope * (s - 0.7) + (cloth ? kCloth : 0.0);
    };
    plan.noise = noise;
    // Four holes, each a quarter of the share.
    if (holes > 0)
      plan.missing = [*this](double, double phi) {
        return std::fmod(phi + kPi, kPi / 2) < holes * kPi / 2;
      };
    return plan;
  }
};

constexpr StepPlan kPlans[] = {
    // Straight edges on a boundary between rows of the map, within a row, and on the next boundary.
    {"between_rows", true, 0, 0, 0, 0, 0, 0.7},
    {"in_a_row", true, 0, 0, 0, 0, 0, 0.701},
    {"mid_row", true, 0, 0, 0, 0, 0, 0.702},
    {"waist", false, 0, 0, 0, 0, 0, 0.7},
    {"waist_in_a_row", false, 0, 0, 0, 0, 0, 0.703},
    {"wave", true, 0, 0.015},
    {"tilt", true, 0, 0, 0.03},
    {"cone", true, -0.25, 0.015},
    {"widening_cone", false, 0.4, 0.01, 0.02},
    {"noise", true, 0, 0, 0, 0.001},
    {"noisy_wave", false, 0, 0.015, 0.01, 0.001},
    {"holes", true, 0, 0.01, 0, 0, 0.2},
    {"all", true, -0.2, 0.01, 0.01, 0.001, 0.2},
};

double mean_error(const FoundEdge& found, const LimbMap& map, const StepPlan& plan) {
  double sum = 0;
  for (int j = 0; j < map.columns; ++j)
    sum += std::abs(found.s[j] - plan.edge(map.column_phi(j))) / map.columns;
  return sum;
}

class FindEdge : public testing::TestWithParam<StepPlan> {};

TEST_P(FindEdge, FindsAStepOfClothThickness) {
  const StepPlan& plan = GetParam();
  const LimbMap map = test::limb_map(plan.limb(), 21);
  EdgeSearch search;
  search.garment_above = plan.garment_above;
  search.s_low = 0.5, search.s_high = 0.9;
  const FoundEdge found = find_edge(map, search);
  ASSERT_TRUE(found.found());
  ASSERT_EQ(found.s.size(), static_cast<std::size_t>(map.columns));
  EXPECT_LE(mean_error(found, map, plan), kHalfRow);
  EXPECT_GE(found.coverage, 0.95 - plan.holes);
  EXPECT_LE(found.coverage, 1.0001 - plan.holes + 0.03);
  EXPECT_NEAR(found.typical_step, kCloth, 0.001);
  EXPECT_GT(found.score, 0.8 * (1 - plan.holes));
  EXPECT_EQ(found.evidence, "step");
  EXPECT_LT(found.standard_error, 0.004);
  // The garment's surface at the edge, where it was seen.
  for (int j = 0; j < map.columns; ++j) {
    const double s = plan.edge(map.column_phi(j));
    if (found.seen[j]) {
      EXPECT_NEAR(found.r[j], 0.16 + plan.slope * (s - 0.7) + kCloth, 0.0025);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Limbs, FindEdge, testing::ValuesIn(kPlans),
                         [](const auto& plan) { return std::string(plan.param.name); });

TEST(FindEdgeNone, BareSkinHasNoConvincingEdge) {
  for (const double noise : {0.0, 0.001}) {
    LimbPlan limb;
    limb.radius = [](double s, double phi) {
      return 0.14 + 0.05 * (s - 0.7) * (s - 0.7) + 0.01 * std::cos(2 * phi);
    };
    limb.noise = noise;
    EdgeSearch search;
    search.s_low = 0.5, search.s_high = 0.9;
    const FoundEdge found = find_edge(test::limb_map(limb, 22), search);
    // Full evidence is 1; a garment is believed from well above the half of it.
    EXPECT_TRUE(found.coverage < 0.5 || found.score < 0.5) << found.coverage << ", " << found.score;
  }
}

TEST(FindEdgeNone, AStepTheWrongWayRoundIsNoEdge) {
  StepPlan plan{"below", false};
  EdgeSearch search;
  search.garment_above = true;
  search.s_low = 0.5, search.s_high = 0.9;
  const FoundEdge found = find_edge(test::limb_map(plan.limb(), 23), search);
  // Beside such a step the fit of parallel lines sees a smaller step of the right kind.
  EXPECT_TRUE(found.coverage < 0.5 || found.score < 0.7) << found.coverage << ", " << found.score;
}

TEST(FindEdgeNone, WithoutDataThereIsNothing) {
  LimbMap map = test::limb_map(StepPlan{"any"}.limb(), 24, 36, 0.01);
  EdgeSearch search;
  search.s_low = 2, search.s_high = 3;
  EXPECT_FALSE(find_edge(map, search).found());
  EdgeSearch within;
  within.s_low = 0.5, within.s_high = 0.9;
  std::fill(map.count.begin(), map.count.end(), 0);
  const FoundEdge found = find_edge(map, within);
  EXPECT_TRUE(!found.found() || found.coverage == 0) << found.coverage;
}

TEST(FindEdgeColour, AColourEdgeWithoutAStepIsFoundWhenThereAreColours) {
  const StepPlan plan{"colour", true, 0, 0.015};
  LimbPlan limb = plan.limb();
  limb.radius = [](double, double) { return 0.16; };
  EdgeSearch search;
  search.s_low = 0.5, search.s_high = 0.9;
  const FoundEdge blind = find_edge(test::limb_map(limb, 25), search);
  EXPECT_TRUE(blind.coverage < 0.5 || blind.score < 0.5);
  limb.colour = [&](double s, double phi) {
    return s > plan.edge(phi) ? Vec3(0.2, 0.3, 0.6) : Vec3(0.8, 0.6, 0.5);
  };
  const LimbMap map = test::limb_map(limb, 25);
  const FoundEdge found = find_edge(map, search);
  ASSERT_TRUE(found.found());
  EXPECT_LE(mean_error(found, map, plan), kHalfRow);
  EXPECT_GT(found.coverage, 0.95);
  EXPECT_GT(found.score, 0.8);
  EXPECT_EQ(found.evidence, "colour");
  EXPECT_NEAR(found.contrast, (Vec3(0.2, 0.3, 0.6) - Vec3(0.8, 0.6, 0.5)).norm(), 0.02);
}

TEST(FindEdgeDrop, ClothAboveNothingIsAnEdge) {
  const StepPlan plan{"drop", true, 0, 0.015};
  LimbPlan limb = plan.limb();
  limb.missing = [&](double s, double phi) { return s < plan.edge(phi); };
  const LimbMap map = test::limb_map(limb, 26);
  EdgeSearch search;
  search.s_low = 0.5, search.s_high = 0.9;
  const FoundEdge found = find_edge(map, search);
  ASSERT_TRUE(found.found());
  EXPECT_LE(mean_error(found, map, plan), kHalfRow);
  EXPECT_GT(found.coverage, 0.95);
  EXPECT_EQ(found.evidence, "drop");
}

TEST(FindEdgeCentre, OfTwoEqualEdgesTheOneExpectedIsTaken) {
  LimbPlan limb;
  limb.radius = [](double s, double) {
    return 0.16 + (s > 0.6 ? kCloth : 0) + (s > 0.8 ? kCloth : 0);
  };
  const LimbMap map = test::limb_map(limb, 27);
  for (const double expected : {0.6, 0.8}) {
    EdgeSearch search;
    search.s_low = 0.5, search.s_high = 0.95;
    search.centre.assign(map.columns, expected + 0.01);
    search.spread = 0.03;
    const FoundEdge found = find_edge(map, search);
    for (double s : found.s) EXPECT_NEAR(s, expected, 0.004);
  }
}

// Thin cloth ends at 0.8 m; at 0.6 m a fold stands far off on three quarters of the loop.
TEST(FindEdges, AnEdgeIsMoreEvenThanAFoldThatStandsOffFurther) {
  LimbPlan limb;
  limb.radius = [](double s, double phi) {
    const double fold = std::abs(phi) < 0.75 * kPi ? 0.008 : 0;
    return 0.16 + (s < 0.8 ? 0.002 : 0) + (s < 0.6 ? fold : 0);
  };
  const LimbMap map = test::limb_map(limb, 31);
  EdgeSearch search;
  search.garment_above = false;
  search.s_low = 0.5, search.s_high = 0.95;
  search.straightness = 0.015, search.tilt = 0.02;
  const FoundEdge *edge = nullptr, *fold = nullptr;
  const std::vector<FoundEdge> places = find_edges(map, search, 6);
  for (const FoundEdge& place : places) {
    const double front = place.s[map.columns / 2];
    if (!edge && std::abs(front - 0.8) < 0.004) edge = &place;
    if (!fold && std::abs(front - 0.6) < 0.004) fold = &place;
  }
  ASSERT_TRUE(edge && fold);
  EXPECT_GT(fold->score, edge->score);
  EXPECT_GT(edge->even_score, fold->even_score + 0.3);
}

TEST(FindEdges, ColoursTellEdgesFromFolds) {
  LimbPlan limb;
  limb.radius = [](double s, double) { return 0.16 + (s < 0.7 ? 0.002 : 0); };
  limb.colour = [](double s, double) {
    return s < 0.7 ? Vec3(0.8, 0.2, 0.2) : Vec3(0.7, 0.6, 0.5);
  };
  EdgeSearch search;
  search.garment_above = false;
  search.s_low = 0.5, search.s_high = 0.95;
  const FoundEdge found = find_edge(test::limb_map(limb, 32), search);
  EXPECT_EQ(found.even_score, found.score);
}

TEST(EdgePoints, LieOnTheGarmentAtTheEdge) {
  const StepPlan plan{"tilt", true, 0, 0, 0.03};
  const LimbMap map = test::limb_map(plan.limb(), 28);
  EdgeSearch search;
  search.s_low = 0.5, search.s_high = 0.9;
  const FoundEdge found = find_edge(map, search);
  const std::vector<Vec3> points = edge_points(found, map, test::upright_axis(0.4, 1.0));
  ASSERT_EQ(points.size(), static_cast<std::size_t>(map.columns));
  for (int j = 0; j < map.columns; ++j) {
    const double phi = map.column_phi(j);
    EXPECT_LT(
        (points[j] - Vec3(0.164 * std::sin(phi), plan.edge(phi), 0.164 * std::cos(phi))).norm(),
        0.008);
  }
}

}  // namespace
}  // namespace regarment
