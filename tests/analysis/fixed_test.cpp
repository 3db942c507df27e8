// What a person knows is held, and help for one garment is not taken for another's.
#include "findings.h"

namespace regarment {
namespace {

using test::measured;

Scan dressed_scan() {
  test::PersonPlan plan;
  plan.skirt.emplace();
  return test::scan_of(test::make_person(plan).mesh);
}

double waist_height(const Analysis& analysis) {
  for (const EdgeCurve& edge : analysis.garments.at(0).edges) {
    if (edge.name != "waist") continue;
    double sum = 0;
    for (const Vec3& p : edge.points) sum += p.y();
    return sum / static_cast<double>(edge.points.size());
  }
  throw std::out_of_range("no waist");
}

TEST(Fixed, IsHeldExactlyByTheDirectMethod) {
  const Scan scan = dressed_scan();
  const auto templates = test::templates_of({"skirt"});
  const GarmentAnalysis free = analyze(scan, templates).garments.at(0);
  AnalyzeOptions options;
  options.fixed["skirt"] = {{"length", 0.50}};
  options.fabric = Fabric::Woven;
  const Analysis analysis = analyze(scan, templates, options);
  EXPECT_EQ(analysis.fabric, Fabric::Woven);
  const GarmentAnalysis& held = analysis.garments.at(0);
  const Measurement& length = measured(held, "length");
  EXPECT_TRUE(length.fixed && length.observable);
  EXPECT_EQ(length.flat, 0.50);
  EXPECT_EQ(length.low, 0.50);
  EXPECT_EQ(length.high, 0.50);
  // The scan goes on showing how it is worn, and the girths do not hang on it.
  EXPECT_EQ(length.worn, measured(free, "length").worn);
  EXPECT_EQ(held.dimensions.at("length"), 0.50);
  EXPECT_FALSE(measured(held, "waist").fixed);
  EXPECT_NEAR(measured(held, "waist").flat, measured(free, "waist").flat, 1e-6);
  EXPECT_GT(free.silhouette.value_or(-1), 0);
}

TEST(Fixed, IsRefusedWhereNoGarmentAskedForCanHaveIt) {
  AnalyzeOptions options;
  options.fixed["tshirt"] = {{"length", 0.6}};
  EXPECT_THROW(analyze(dressed_scan(), test::templates_of({"skirt"}), options), UsageError);
  options.fixed = {{"skirt", {{"length", 0.1}}}};
  EXPECT_THROW(analyze(dressed_scan(), test::templates_of({"skirt"}), options), UsageError);
}

TEST(Hints, CountForTheGarmentTheyName) {
  const Scan scan = dressed_scan();
  const auto templates = test::templates_of({"skirt"});
  const double found = waist_height(analyze(scan, templates));
  AnalyzeOptions options;
  // Out of reach of the edge that is there.
  options.placement.edges = {{"tshirt.waist", found - 0.12}};
  EXPECT_EQ(waist_height(analyze(scan, templates, options)), found);
  options.placement.edges["skirt.waist"] = found - 0.12;
  EXPECT_NEAR(waist_height(analyze(scan, templates, options)), found - 0.12, 0.035);
  options.placement.edges["waist"] = found;  // counts less than the garment's own
  EXPECT_NEAR(waist_height(analyze(scan, templates, options)), found - 0.12, 0.035);
}

}  // namespace
}  // namespace regarment
