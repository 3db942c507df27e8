#include <numbers>

#include "analysis/analyze.h"
#include "analysis/weigh_estimates.h"
#include "findings.h"

namespace regarment {
namespace {

using test::MadeSkirt;
using test::measured;
using test::PersonPlan;

AnalyzeOptions joint() {
  AnalyzeOptions options;
  options.method = Method::Joint;
  return options;
}

PersonPlan wearer() {
  PersonPlan plan;
  plan.skirt = MadeSkirt{1.03, 0.129, 0.45, 0.21};
  return plan;
}

GarmentAnalysis skirt_of(const PersonPlan& plan, const AnalyzeOptions& options) {
  const Scan scan = test::scan_of(test::make_person(plan).mesh, plan.edge);
  return analyze(scan, test::templates_of({"skirt"}), options).garments.at(0);
}

// A frustum's circumferences, and lengths along its slant. Rolled out, its edges are arcs and the
// template's are straight, so that no skirt of the template fits it better than to a centimetre or
// so.
TEST(JointGarment, FindsAMadeSkirt) {
  const PersonPlan plan = wearer();
  const MadeSkirt& made = *plan.skirt;
  const GarmentAnalysis skirt = skirt_of(plan, joint());
  constexpr double kTurn = 2 * std::numbers::pi;
  const double slope = (made.hem_radius - made.waist_radius) / made.slant();
  const Dimensions truth = {{"waist", kTurn * made.waist_radius},
                            {"hip", kTurn * (made.waist_radius + 0.2 * slope)},
                            {"width", kTurn * made.hem_radius},
                            {"length", made.slant()}};
  for (const auto& [name, value] : truth) {
    const Measurement& m = measured(skirt, name);
    EXPECT_TRUE(m.observable) << name;
    ASSERT_TRUE(m.worn && m.sources) << name;
    EXPECT_NEAR(*m.worn, value, 0.015) << name;
    EXPECT_LE(m.low, value) << name;
    EXPECT_GE(m.high, value) << name;
  }
  for (const Vec3& p : skirt.draped)
    EXPECT_NEAR(std::hypot(p.x(), p.z()), made.radius(p.y()), 0.03);
  EXPECT_LT(skirt.mean_distance, 0.005);
  EXPECT_NEAR(loop_length(skirt.pattern, edge_named(skirt.pattern, "hem")),
              skirt.dimensions.at("width"), 1e-9);
}

TEST(JointGarment, HoldsWhatAPersonKnows) {
  AnalyzeOptions options = joint();
  options.fixed["skirt"] = {{"length", 0.55}};
  const GarmentAnalysis skirt = skirt_of(wearer(), options);
  const Measurement& m = measured(skirt, "length");
  EXPECT_TRUE(m.fixed);
  EXPECT_EQ(m.flat, 0.55);
  EXPECT_EQ(m.low, 0.55);
  EXPECT_EQ(m.high, 0.55);
  EXPECT_EQ(skirt.dimensions.at("length"), 0.55);
}

TEST(JointGarment, KnowsTighterIntervalsForClothThatHardlyGives) {
  AnalyzeOptions woven = joint(), elastic = joint();
  woven.fabric = Fabric::Woven, elastic.fabric = Fabric::Elastic;
  const Measurement stiff = measured(skirt_of(wearer(), woven), "waist");
  const Measurement soft = measured(skirt_of(wearer(), elastic), "waist");
  EXPECT_EQ(stiff.worn, soft.worn);
  EXPECT_GT(stiff.flat, soft.flat);
  EXPECT_LT(stiff.high - stiff.low, soft.high - soft.low);
}

TEST(JointGarment, ANakedPersonWearsNothing) {
  const Scan scan = test::scan_of(test::make_person(PersonPlan{}).mesh);
  EXPECT_THROW(analyze(scan, test::templates_of({"skirt"}), joint()), NoGarmentError);
}

TEST(Weigh, KeepsWhatAllSay) {
  for (const DimensionRole role : {DimensionRole::Hoop, DimensionRole::LimbLength}) {
    EXPECT_NEAR(weigh({0.9, 0.9, 0.9}, role).value, 0.9, 1e-12);
    EXPECT_NEAR(weigh({0.9, 0.9, std::nullopt}, role).value, 0.9, 1e-12);
  }
}

TEST(Weigh, LiesBetweenItsSourcesAndDoubtsThemWhenTheyDisagree) {
  const WornEstimate near = weigh({0.90, 0.91, 0.905}, DimensionRole::TorsoEdge);
  const WornEstimate apart = weigh({0.90, 0.95, 0.925}, DimensionRole::TorsoEdge);
  EXPECT_GT(near.value, 0.90);
  EXPECT_LT(near.value, 0.91);
  EXPECT_GT(apart.standard_deviation, 3 * near.standard_deviation);
  // Twice as large in all sources: twice the value.
  EXPECT_NEAR(weigh({1.80, 1.90, 1.85}, DimensionRole::TorsoEdge).value, 2 * apart.value, 1e-12);
}

TEST(Weigh, LooksForMoreWhereAnArmpitHidesAPartOfTheEdge) {
  const WornSources sources{0.34, 0.34, 0.34};
  const WornEstimate seen = weigh(sources, DimensionRole::LimbEdge);
  const WornEstimate one = weigh(sources, DimensionRole::LimbEdge, 0.5);
  const WornEstimate both = weigh(sources, DimensionRole::LimbEdge, 1);
  EXPECT_EQ(seen.above, 0);
  EXPECT_LT(seen.value, one.value);
  EXPECT_LT(one.value, both.value);
  EXPECT_GT(both.above, one.above);
  // What shows is a lower bound: it is not left out of the interval.
  EXPECT_LT(both.value - 1.645 * both.standard_deviation, 0.34);
  EXPECT_GT(both.standard_deviation, seen.standard_deviation);
  // A hem does not lie in an armpit.
  EXPECT_EQ(weigh(sources, DimensionRole::TorsoEdge, 1).value,
            weigh(sources, DimensionRole::TorsoEdge).value);
}

}  // namespace
}  // namespace regarment
