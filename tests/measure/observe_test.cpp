#include "measure/observe.h"

#include <gtest/gtest.h>

#include "garment/find_template.h"
#include "support/closed_forms.h"
#include "support/limbs.h"

namespace regarment {
namespace {

using test::LimbPlan;

constexpr double kPi = std::numbers::pi;

/// A skirt made of a surface of revolution, its edges put where they are.
struct Worn {
  double waist_y = 1.0, hem_y = 0.5;
  std::function<double(double y, double phi)> radius;
  double noise = 0;
  std::function<bool(double y, double phi)> missing;

  std::map<std::string, ObservedLength> observe_skirt() const {
    const GarmentTemplate skirt = find_template("skirt");
    LimbPlan limb;
    limb.low = hem_y, limb.high = waist_y, limb.spacing = 0.0025;
    limb.radius = radius, limb.noise = noise, limb.missing = missing;
    const SurfaceSamples samples = test::limb_samples(limb, 61);
    const LimbAxis axis = test::upright_axis(0.0, 1.6);
    GarmentEdges edges;
    edges.limbs.emplace(
        "torso",
        LimbView{axis, make_limb_map(samples, test::all_of(samples), axis, 0.0, 1.5, 0.004, 144),
                 test::all_of(samples)});
    for (const char* name : {"waist", "hem"}) {
      const double y = std::string(name) == "waist" ? waist_y : hem_y;
      GarmentEdge edge;
      edge.limb = "torso", edge.garment_above = y == hem_y;
      edge.found.s.assign(144, y);
      edge.found.seen.assign(144, true);
      edge.found.step.assign(144, 0.004);
      for (int j = 0; j < 144; ++j)
        edge.found.r.push_back(radius(y, edges.limbs.at("torso").map.column_phi(j)));
      edge.found.coverage = 1, edge.found.score = 1;
      edges.edges.emplace(name, std::move(edge));
    }
    Body body;
    body.height = 1.7;
    body.part.assign(samples.size(), BodyPart::Trunk);
    std::map<std::string, ObservedLength> out;
    for (const ObservedLength& o :
         observe(samples, body, edges, std::vector<std::uint8_t>(samples.size(), 1), skirt))
      out.emplace(o.observation->equals, o);
    // The template they point into ends here.
    for (auto& [name, o] : out) o.observation = nullptr;
    return out;
  }
};

void expect_length(const ObservedLength& observed, double truth, double tolerance) {
  EXPECT_TRUE(observed.seen);
  EXPECT_NEAR(observed.value, truth, tolerance);
  EXPECT_GT(observed.standard_deviation, 0);
  EXPECT_LT(observed.standard_deviation, 0.1 * truth);
}

TEST(ObserveSkirt, OnAConeGivesTheMeasuresOfTheFrustum) {
  for (const double noise : {0.0, 0.0007})
    for (const double slope : {0.05, 0.15, 0.3}) {
      Worn worn;
      worn.radius = [=](double y, double) { return 0.13 + slope * (1.0 - y); };
      worn.noise = noise;
      const auto observed = worn.observe_skirt();
      const double slant = std::hypot(1, slope);
      expect_length(observed.at("waist"), test::circle_length(0.13), 0.01);
      expect_length(observed.at("width"), test::circle_length(0.13 + slope * 0.5), 0.012);
      expect_length(observed.at("length"), 0.5 * slant, 0.004);
      // 20 cm down the slant from the waist.
      expect_length(observed.at("hip"), test::circle_length(0.13 + slope * 0.2 / slant), 0.015);
    }
}

TEST(ObserveSkirt, OnAnEllipticCylinderEveryGirthIsItsPerimeter) {
  Worn worn;
  const double a = 0.17, b = 0.12;
  worn.radius = [=](double, double phi) {
    return a * b / std::hypot(b * std::sin(phi), a * std::cos(phi));
  };
  const auto observed = worn.observe_skirt();
  for (const char* name : {"waist", "hip", "width"})
    expect_length(observed.at(name), test::ellipse_length(a, b), 0.01);
  expect_length(observed.at("length"), 0.5, 0.004);
}

TEST(ObserveSkirt, TheFoldsOfAHemCount) {
  Worn worn;
  const auto amplitude = [](double y) { return 0.03 * (1.0 - y) / 0.5; };
  worn.radius = [=](double y, double phi) {
    return 0.13 + 0.15 * (1.0 - y) + amplitude(y) * std::cos(8 * phi);
  };
  const double hem = test::curve_length([&](double t) {
    const double phi = 2 * kPi * t, r = worn.radius(0.5, phi);
    return Vec2(r * std::cos(phi), r * std::sin(phi));
  });
  ASSERT_GT(hem, 1.1 * test::circle_length(0.205));
  const auto observed = worn.observe_skirt();
  expect_length(observed.at("width"), hem, 0.02 * hem);
  expect_length(observed.at("waist"), test::circle_length(0.13), 0.012);
}

TEST(ObserveSkirt, AStripWithoutDataIsBridged) {
  Worn worn;
  worn.radius = [](double y, double) { return 0.13 + 0.15 * (1.0 - y); };
  worn.missing = [](double, double phi) { return phi > 1.2 && phi < 1.8; };
  const auto observed = worn.observe_skirt();
  expect_length(observed.at("width"), test::circle_length(0.205), 0.03);
  expect_length(observed.at("waist"), test::circle_length(0.13), 0.02);
  expect_length(observed.at("length"), 0.5 * std::hypot(1, 0.15), 0.004);
}

}  // namespace
}  // namespace regarment
