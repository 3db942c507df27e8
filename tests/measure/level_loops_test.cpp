#include "measure/level_loops.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/limbs.h"

namespace regarment {
namespace {

using test::LimbPlan;

constexpr double kRow = 0.004;  // m, of the map

/// Cloth of a thickness below a level edge that tilts and dips at the sides, as a waist does.
struct WaistPlan {
  double at = 0.7, front = 0, left = 0, dip = 0, cloth = 0.004;  // m

  double edge(double phi) const {
    return at + front * std::cos(phi) + left * std::sin(phi) + dip * std::cos(2 * phi);
  }
  LimbPlan limb(double noise) const {
    LimbPlan plan;
    plan.radius = [*this](double s, double phi) { return 0.16 + (s < edge(phi) ? cloth : 0.0); };
    plan.noise = noise;
    return plan;
  }
};

EdgeSearch waist_search() {
  EdgeSearch search;
  search.garment_above = false;
  search.s_low = 0.5, search.s_high = 0.9;
  search.straightness = 0.012, search.tilt = 0.05, search.dip = 0.03;
  return search;
}

double mean_error(const FoundEdge& found, const LimbMap& map, const WaistPlan& plan) {
  double sum = 0;
  for (int j = 0; j < map.columns; ++j)
    sum += std::abs(found.s[j] - plan.edge(map.column_phi(j))) / map.columns;
  return sum;
}

TEST(LevelLoops, FollowTiltAndDip) {
  for (const WaistPlan plan : {WaistPlan{0.7}, WaistPlan{0.7, 0.03}, WaistPlan{0.72, -0.02, 0.03},
                               WaistPlan{0.68, 0.01, -0.01, 0.02}}) {
    const LimbMap map = test::limb_map(plan.limb(0.0005), 41);
    const EdgeEvidence evidence = edge_evidence(map, waist_search());
    const std::vector<LevelLoop> loops = level_loops(evidence, map, waist_search(), 1);
    ASSERT_EQ(loops.size(), 1U);
    for (int j = 0; j < map.columns; ++j) {
      const double s = map.s_low + (evidence.low + loops[0].row[j]) * map.step;
      // Amplitudes are tried in steps of a centimetre, heights by rows.
      EXPECT_NEAR(s, plan.edge(map.column_phi(j)), 0.011);
    }
    const FoundEdge found = find_edge(map, waist_search());
    EXPECT_LT(mean_error(found, map, plan), 0.5 * kRow + 1e-9);
  }
}

// A third of a cloth's usual thickness under noise as large: no column is sure of it.
TEST(LevelLoops, AFaintEdgeShowsInTheWholeLoop) {
  const WaistPlan plan{0.7, 0.02, 0, 0, 0.0013};
  const LimbMap map = test::limb_map(plan.limb(0.0013), 42);
  const FoundEdge found = find_edge(map, waist_search());
  ASSERT_TRUE(found.found());
  EXPECT_LT(mean_error(found, map, plan), kRow);
  EXPECT_LT(found.score, 0.8);
}

TEST(LevelLoops, FaintEdgesHaveLargerErrors) {
  EdgeSearch search = waist_search();
  search.least_error = 0.002;
  const FoundEdge sure = find_edge(test::limb_map(WaistPlan{}.limb(0.0003), 43), search);
  const WaistPlan thin{0.7, 0, 0, 0, 0.0013};
  const FoundEdge faint = find_edge(test::limb_map(thin.limb(0.0003), 43), search);
  EXPECT_GE(sure.standard_error, 0.002);
  EXPECT_GT(faint.standard_error, 1.5 * sure.standard_error);
}

TEST(FindEdges, SaysEachOfTwoBestFirst) {
  LimbPlan limb;
  limb.radius = [](double s, double) {
    return 0.16 + (s < 0.6 ? 0.002 : 0.0) + (s < 0.8 ? 0.004 : 0.0);
  };
  const LimbMap map = test::limb_map(limb, 44);
  for (const double straightness : {0.0, 0.012}) {
    EdgeSearch search = waist_search();
    search.straightness = straightness;
    const std::vector<FoundEdge> found = find_edges(map, search, 2);
    ASSERT_EQ(found.size(), 2U);
    for (const double s : found[0].s) EXPECT_NEAR(s, 0.8, kRow);
    for (const double s : found[1].s) EXPECT_NEAR(s, 0.6, kRow);
    EXPECT_GT(found[0].score, found[1].score);
  }
}

TEST(FindEdges, ARangeWithoutRowsHasNone) {
  EdgeSearch search = waist_search();
  search.s_low = 2, search.s_high = 3;
  EXPECT_TRUE(find_edges(test::limb_map(WaistPlan{}.limb(0), 45), search, 3).empty());
}

// Stripes are stronger in colour than the edge of the cloth.
TEST(FindEdges, StripesAreNoEdges) {
  LimbPlan limb;
  const WaistPlan plan{0.7, 0, 0, 0, 0.003};
  limb.radius = plan.limb(0).radius;
  limb.colour = [](double s, double) {
    if (s > 0.7) return Vec3(0.8, 0.6, 0.5);
    return std::fmod(s + 0.01, 0.06) < 0.03 ? Vec3(0.1, 0.1, 0.2) : Vec3(0.9, 0.9, 0.5);
  };
  const LimbMap map = test::limb_map(limb, 46);
  const FoundEdge found = find_edge(map, waist_search());
  EXPECT_LT(mean_error(found, map, plan), kRow);
  EXPECT_EQ(found.evidence, "colour");
}

}  // namespace
}  // namespace regarment
