// The paper's search from end to end, with far fewer drapes than it takes to be exact.
#include "findings.h"

namespace regarment {
namespace {

using test::MadePart;
using test::MadePerson;

MadePerson person_in_skirt(bool capped) {
  test::PersonPlan plan;
  plan.skirt.emplace();
  plan.skirt->capped = capped;
  plan.edge = 0.012;
  return test::make_person(plan);
}

AnalyzeOptions few_drapes() {
  AnalyzeOptions options;
  options.method = Method::Annealing;
  options.pattern_edge_length = 0.06;
  options.fit.runs = 1;
  options.fit.search.max_evaluations = 8;
  options.fit.rough_evaluations = 8;
  options.fit.silhouette_size = 128;
  return options;
}

Analysis anneal(const Scan& scan, const AnalyzeOptions& options = few_drapes()) {
  return analyze(scan, test::templates_of({"skirt"}), options);
}

Vec3 nearest_on_side(const Vec3& a, const Vec3& b, const Vec3& p) {
  return a + std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) * (b - a);
}

/// Nearest point of a triangle: the foot of the perpendicular when inside, else on a side.
Vec3 nearest_on_triangle(const std::array<Vec3, 3>& t, const Vec3& p) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const Vec3 foot = p - n * n.dot(p - t[0]) / n.squaredNorm();
  bool inside = true;
  Vec3 best = t[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = t[k], &b = t[(k + 1) % 3];
    inside = inside && n.dot((b - a).cross(foot - a)) >= 0;
    const Vec3 q = nearest_on_side(a, b, p);
    if ((q - p).norm() < (best - p).norm()) best = q;
  }
  return inside ? foot : best;
}

/// Nearest point of the draped garment by looking at every triangle.
Vec3 nearest_on_garment(const GarmentAnalysis& garment, const Vec3& p) {
  Vec3 best = Vec3::Constant(1e9);
  for (const Triangle& t : garment.pattern.triangles) {
    const Vec3 q =
        nearest_on_triangle({garment.draped[t[0]], garment.draped[t[1]], garment.draped[t[2]]}, p);
    if ((q - p).norm() < (best - p).norm()) best = q;
  }
  return best;
}

TEST(Annealing, KeepsItsTraceAndTheBestOfIt) {
  const Scan scan = test::scan_of(person_in_skirt(false).mesh);
  const Analysis analysis = anneal(scan);
  EXPECT_EQ(analysis.method, "annealing");
  const GarmentAnalysis& skirt = analysis.garments.at(0);
  ASSERT_TRUE(skirt.trace.has_value());
  ASSERT_EQ(skirt.trace->runs.size(), 1U);
  const FitRun& run = skirt.trace->runs[0];
  EXPECT_LE(run.evaluations.size(), 8U);
  const FitEvaluation& best = run.evaluations.at(run.best);
  EXPECT_EQ(skirt.terms.distance, best.terms.distance);
  EXPECT_EQ(skirt.terms.silhouette, best.terms.silhouette);
  ASSERT_EQ(skirt.trace->names.size(), best.dimensions.size());
  for (std::size_t i = 0; i < best.dimensions.size(); ++i) {
    const Measurement& m = test::measured(skirt, skirt.trace->names[i]);
    EXPECT_EQ(m.flat, best.dimensions[i]);
    EXPECT_EQ(skirt.dimensions.at(m.name), m.flat);
    EXPECT_LE(m.low, m.flat);
    EXPECT_GE(m.high, m.flat);
  }
  // The pattern is the garment that was found.
  EXPECT_NEAR(loop_length(skirt.pattern, edge_named(skirt.pattern, "hem")),
              skirt.dimensions.at("width"), 1e-9);
  EXPECT_EQ(skirt.draped.size(), skirt.pattern.flat.size());
}

TEST(Annealing, LabelsWhatLiesNearTheDrapedGarmentAndMeasuresHowFar) {
  const Scan scan = test::scan_of(person_in_skirt(false).mesh);
  AnalyzeOptions options = few_drapes();
  options.segment_distance = 0.015;
  const Analysis analysis = anneal(scan, options);
  const GarmentAnalysis& skirt = analysis.garments.at(0);
  ASSERT_EQ(analysis.labels.size(), scan.mesh.positions.size());
  ASSERT_EQ(skirt.deviation.size(), scan.mesh.positions.size());
  std::size_t labelled = 0, agreeing = 0, clear = 0;
  for (std::size_t v = 0; v < scan.mesh.positions.size(); ++v) {
    EXPECT_EQ(std::isnan(skirt.deviation[v]), analysis.labels[v] != 1) << v;
    labelled += analysis.labels[v] == 1;
    if (v % 7 != 0) continue;
    const Vec3& p = scan.mesh.positions[v];
    const Vec3 away = p - nearest_on_garment(skirt, p);
    EXPECT_EQ(analysis.labels[v] == 1, away.norm() <= options.segment_distance) << v;
    if (analysis.labels[v] != 1) continue;
    EXPECT_NEAR(std::abs(skirt.deviation[v]), away.norm(), 1e-6);  // m, a float's digits
    // Above the cloth or below it, as seen from the axis of the made skirt.
    const double outwards = Vec3(p.x(), 0, p.z()).normalized().dot(away);
    if (std::abs(outwards) <= 0.003) continue;
    ++clear;
    agreeing += (skirt.deviation[v] > 0) == (outwards > 0);
  }
  ASSERT_GT(clear, 10U);
  EXPECT_GE(agreeing, clear - clear / 20);  // cloth after so few drapes folds back in places
  EXPECT_EQ(labelled, skirt.vertices_labelled);
}

TEST(Annealing, FindsMostOfTheSkirt) {
  const MadePerson person = person_in_skirt(false);
  AnalyzeOptions options = few_drapes();
  options.fit.search.max_evaluations = 20;
  options.fit.rough_evaluations = 12;
  const Analysis analysis = anneal(test::scan_of(person.mesh), options);
  double both = 0, either = 0;
  for (std::size_t v = 0; v < person.part.size(); ++v) {
    const bool found = analysis.labels[v] == 1, made = person.part[v] == MadePart::Skirt;
    both += found && made;
    either += found || made;
  }
  // Held edges show it to the row of triangles, 1.2 of 54 cm, at both ends; 1 cm of skin beside
  // them is within the threshold.
  EXPECT_GT(both / either, 0.85);
}

TEST(Annealing, CapsUnderAHemAreLeftOutOnlyWhenAsked) {
  const Scan scan = test::scan_of(person_in_skirt(true).mesh);
  AnalyzeOptions options = few_drapes();
  const Analysis with = anneal(scan, options);
  options.cap_detection = false;
  const Analysis without = anneal(scan, options);
  EXPECT_GT(std::count(with.cap.begin(), with.cap.end(), 1), 0);
  EXPECT_EQ(std::count(without.cap.begin(), without.cap.end(), 1), 0);
}

TEST(Annealing, TheSameInputGivesTheSameBits) {
  const Scan scan = test::scan_of(person_in_skirt(true).mesh);
  const Analysis a = anneal(scan), b = anneal(scan);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.label_probability, b.label_probability);
  EXPECT_EQ(a.cap, b.cap);
  const GarmentAnalysis &p = a.garments.at(0), &q = b.garments.at(0);
  EXPECT_EQ(p.dimensions, q.dimensions);
  EXPECT_EQ(p.draped, q.draped);
  EXPECT_EQ(p.mean_distance, q.mean_distance);
  ASSERT_EQ(p.deviation.size(), q.deviation.size());
  for (std::size_t v = 0; v < p.deviation.size(); ++v)
    EXPECT_TRUE(p.deviation[v] == q.deviation[v] ||
                (std::isnan(p.deviation[v]) && std::isnan(q.deviation[v])));
}

TEST(Annealing, StopsWhenProgressSaysSo) {
  const Scan scan = test::scan_of(person_in_skirt(false).mesh);
  const Progress stop_in_fit([](std::string_view stage, double) { return stage != "fit"; });
  EXPECT_THROW(analyze(scan, test::templates_of({"skirt"}), few_drapes(), stop_in_fit), Stopped);
}

TEST(Annealing, FindsNoSkirtOnANakedPerson) {
  test::PersonPlan plan;
  plan.edge = 0.012;
  EXPECT_THROW(anneal(test::scan_of(test::make_person(plan).mesh)), NoGarmentError);
}

TEST(Annealing, RefusesOptionsOutOfRange) {
  const Scan scan = test::scan_of(person_in_skirt(false).mesh);
  for (const double distance : {0.0, -0.01, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    AnalyzeOptions options = few_drapes();
    options.segment_distance = distance;
    EXPECT_THROW(anneal(scan, options), InvalidInput) << distance;
  }
  AnalyzeOptions options = few_drapes();
  options.fit.runs = 0;
  EXPECT_THROW(anneal(scan, options), InvalidInput);
}

}  // namespace
}  // namespace regarment
