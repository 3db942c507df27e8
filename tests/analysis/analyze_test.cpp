#include "analysis/analyze.h"

#include <numbers>

#include "findings.h"

namespace regarment {
namespace {

using test::MadePart;
using test::MadePerson;
using test::MadeSkirt;
using test::measured;
using test::PersonPlan;

constexpr double kEdgeError = 0.006;  // m, what an edge's height may be off

/// Flat dimensions of a frustum: circumferences, and lengths along its slant.
Dimensions flat_dimensions(const MadeSkirt& skirt) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double slope = (skirt.hem_radius - skirt.waist_radius) / skirt.slant();
  return {{"waist", kTurn * skirt.waist_radius},
          {"hip", kTurn * (skirt.waist_radius + 0.2 * slope)},
          {"width", kTurn * skirt.hem_radius},
          {"length", skirt.slant()}};
}

struct Case {
  const char* name;
  MadeSkirt skirt;
  double arms = 0.8;
  double cloud = 0;  // m between the points of a cloud; 0 = a mesh
};

class AnalyzeMadeSkirt : public testing::TestWithParam<Case> {
 protected:
  static PersonPlan plan() {
    PersonPlan plan;
    plan.skirt = GetParam().skirt;
    plan.left_arm = plan.right_arm = GetParam().arms;
    return plan;
  }
  /// What a length may be off, m. The line round scattered points swells in the gaps between them,
  /// by 1 / (4 (n reach)^2) of its length for n points a metre and the outline's reach of 6 mm: up
  /// to 2 % here, half of which is averaged away.
  static double tolerance(double length) {
    return 0.01 + (GetParam().cloud > 0 ? 0.01 * length : 0);
  }
  static Scan scan_of(const MadePerson& person) {
    const double spacing = GetParam().cloud;
    if (spacing <= 0) return test::scan_of(person.mesh, plan().edge);
    return test::scan_of(test::cloud_of(person.mesh, spacing, 81), test::kNearestShare * spacing);
  }
};

TEST_P(AnalyzeMadeSkirt, FindsItsDimensionsEdgesAndVertices) {
  const MadePerson person = test::make_person(plan());
  const Scan scan = scan_of(person);
  const Analysis analysis = analyze(scan, test::templates_of({"skirt"}));
  EXPECT_EQ(analysis.method, "direct");
  ASSERT_EQ(analysis.garments.size(), 1U);
  const GarmentAnalysis& skirt = analysis.garments[0];
  EXPECT_EQ(skirt.template_name, "skirt");
  EXPECT_EQ(skirt.layer, 1);
  const Dimensions truth = flat_dimensions(GetParam().skirt);
  ASSERT_EQ(skirt.measurements.size(), truth.size());
  for (const char* name : {"waist", "width", "length"}) {
    const Measurement& m = measured(skirt, name);
    EXPECT_TRUE(m.observable) << name;
    // The girth of a flared hem hangs on the hem's height as well.
    const double growth = (truth.at("width") - truth.at("waist")) / truth.at("length");
    const double most =
        tolerance(truth.at(name)) + (std::string(name) == "width" ? kEdgeError * growth : 0);
    EXPECT_NEAR(m.flat, truth.at(name), most) << name;
    ASSERT_TRUE(m.worn.has_value()) << name;
    EXPECT_NEAR(*m.worn, truth.at(name), most) << name;
    EXPECT_LE(m.low, truth.at(name)) << name;
    EXPECT_GE(m.high, truth.at(name)) << name;
  }
  // The hip line hangs on the waist's height as well.
  EXPECT_NEAR(measured(skirt, "hip").flat, truth.at("hip"), 0.01 + tolerance(truth.at("hip")));

  ASSERT_EQ(skirt.edges.size(), 2U);
  for (const EdgeCurve& edge : skirt.edges) {
    const double y = edge.name == "hem" ? GetParam().skirt.hem_y : GetParam().skirt.waist_y;
    double mean = 0;
    for (const Vec3& p : edge.points) mean += p.y() / static_cast<double>(edge.points.size());
    // A crease where cloth leaves the body moves the step by up to a row of the search, 4 mm.
    EXPECT_NEAR(mean, y, kEdgeError) << edge.name;
    EXPECT_GT(edge.coverage, 0.9) << edge.name;
  }
  EXPECT_EQ(static_cast<std::size_t>(std::count(analysis.labels.begin(), analysis.labels.end(), 1)),
            skirt.vertices_labelled);
  ASSERT_EQ(analysis.labels.size(), scan.mesh.positions.size());
  ASSERT_EQ(analysis.label_probability.size(), scan.mesh.positions.size());
  EXPECT_EQ(analysis.cap.size(), scan.mesh.triangles.size());
}

TEST_P(AnalyzeMadeSkirt, LaysTheGarmentOnTheSkirt) {
  const MadePerson person = test::make_person(plan());
  const Scan scan = scan_of(person);
  const GarmentAnalysis skirt = analyze(scan, test::templates_of({"skirt"})).garments.at(0);
  ASSERT_EQ(skirt.draped.size(), skirt.pattern.flat.size());
  ASSERT_EQ(skirt.placed.size(), skirt.pattern.flat.size());
  const MadeSkirt& made = GetParam().skirt;
  double distance = 0;
  for (const Vec3& p : skirt.draped)
    distance += std::abs(std::hypot(p.x(), p.z()) - made.radius(p.y())) /
                static_cast<double>(skirt.draped.size());
  EXPECT_LT(distance, 0.005);
  EXPECT_LT(skirt.mean_distance, 0.008);
  EXPECT_NEAR(skirt.mean_stretch, 1, 0.03);
  for (const Vec3& p : skirt.placed) EXPECT_FALSE(person.holds(p));
  // The pattern is the garment that was found.
  EXPECT_NEAR(loop_length(skirt.pattern, edge_named(skirt.pattern, "hem")),
              skirt.dimensions.at("width"), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Skirts, AnalyzeMadeSkirt,
                         testing::Values(Case{"knee", {}}, Case{"knee_cloud", {}, 0.8, 0.0037},
                                         Case{"narrow", {1.03, 0.129, 0.45, 0.21}},
                                         Case{"wide_low_arms", {1.02, 0.129, 0.40, 0.33}, 1.0},
                                         Case{"mini_T_pose", {1.03, 0.129, 0.62, 0.235}, 1.5},
                                         Case{"closed_hem", {1.03, 0.129, 0.50, 0.25, true}}),
                         [](const auto& made) { return std::string(made.param.name); });

TEST(Analyze, ANakedPersonWearsNothing) {
  for (const double edge : {0.008, 0.02}) {
    PersonPlan plan;
    plan.edge = edge;
    const Scan scan = test::scan_of(test::make_person(plan).mesh);
    for (const char* name : {"skirt", "tshirt"}) test::expect_no_garment(scan, name);
  }
}

TEST(Analyze, AWearerOfASkirtWearsNoTshirt) {
  PersonPlan plan;
  plan.skirt.emplace();
  test::expect_no_garment(test::scan_of(test::make_person(plan).mesh), "tshirt");
}

TEST(Analyze, SaysWhatAPersonSaidOfAnEdge) {
  PersonPlan plan;
  plan.skirt.emplace();
  AnalyzeOptions options;
  options.placement.edges["hem"] = plan.skirt->hem_y + 0.01;
  const Analysis analysis =
      analyze(test::scan_of(test::make_person(plan).mesh), test::templates_of({"skirt"}), options);
  EXPECT_NEAR(measured(analysis.garments.at(0), "length").flat, plan.skirt->slant(), 0.01);
}

TEST(Analyze, LandmarksAreHeightsOfTheMadePerson) {
  PersonPlan plan;
  plan.skirt.emplace();
  const MadePerson person = test::make_person(plan);
  const auto landmarks =
      analyze(test::scan_of(person.mesh), test::templates_of({"skirt"})).landmarks;
  EXPECT_NEAR(landmarks.at("neck"), MadePerson::kNeck, 0.02);
  EXPECT_NEAR(landmarks.at("left_armpit"), person.armpit(0), 0.02);
  EXPECT_NEAR(landmarks.at("right_armpit"), person.armpit(1), 0.02);
  EXPECT_DOUBLE_EQ(landmarks.at("height"), MadePerson::kHeight);
}

TEST(AnalyzeErrors, WrongUse) {
  const Scan scan = test::scan_of(test::make_person({}).mesh);
  EXPECT_THROW(analyze(scan, {}), UsageError);
  EXPECT_THROW(analyze(scan, std::vector<GarmentTemplate>(9, find_template("skirt"))), UsageError);
  AnalyzeOptions options;
  options.sample_spacing = 0;
  EXPECT_THROW(analyze(scan, test::templates_of({"skirt"}), options), InvalidInput);
  options = {};
  options.pattern_edge_length = 1;
  EXPECT_THROW(analyze(scan, test::templates_of({"skirt"}), options), InvalidInput);
}

TEST(AnalyzeErrors, AnEmptyScanIsNoPerson) {
  EXPECT_THROW(analyze(test::scan_of(Mesh{}), test::templates_of({"skirt"})), NoPersonError);
}

}  // namespace
}  // namespace regarment
