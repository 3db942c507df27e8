#include <numbers>

#include "findings.h"

namespace regarment {
namespace {

using test::MadePart;
using test::MadePerson;
using test::MadeSkirt;
using test::measured;
using test::PersonPlan;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kWaist = 1.03, kCloth = 0.006;  // m: where all skirts begin, and how far apart
constexpr double kPeep = 0.004;  // m seen of a skirt above the hem of the one over it

/// A person in skirts that each cover the upper part of the next.
struct Tiers {
  std::vector<MadeSkirt> skirts;    // outermost first
  Mesh mesh;                        // body frame, m
  std::vector<std::uint8_t> label;  // per vertex: 0 person, i = i-th skirt
};

MadeSkirt reaching(const MadeSkirt& innermost, double hem, double out) {
  return {kWaist, innermost.waist_radius + out, hem, innermost.radius(hem) + out};
}

void add_visible(const MadeSkirt& skirt, double top, double edge, Mesh& mesh) {
  MadeSkirt seen = skirt;
  seen.waist_y = top, seen.waist_radius = skirt.radius(top);
  add_tube(test::skirt_tube(seen), edge, {}, mesh);
}

/// `hems`: heights, outermost first, ascending layers lie further down.
Tiers make_tiers(const std::vector<double>& hems) {
  const MadeSkirt innermost{kWaist, 0.129, hems.back(), 0.129 + 0.16 * (kWaist - hems.back())};
  PersonPlan plan;
  plan.skirt = innermost;
  MadePerson person = test::make_person(plan);
  Tiers out;
  for (std::size_t i = 0; i < hems.size(); ++i)
    out.skirts.push_back(
        reaching(innermost, hems[i], kCloth * static_cast<double>(hems.size() - 1 - i)));
  // Only skin is kept of the person, the skirts are added one by one.
  std::erase_if(person.mesh.triangles,
                [&](const Triangle& t) { return person.part[t[0]] != MadePart::Skin; });
  out.mesh.positions = person.mesh.positions;
  out.mesh.triangles = person.mesh.triangles;
  out.label.assign(out.mesh.positions.size(), 0);
  for (std::size_t i = 0; i < hems.size(); ++i) {
    add_visible(out.skirts[i], i == 0 ? kWaist : hems[i - 1] + kPeep, plan.edge, out.mesh);
    out.label.resize(out.mesh.positions.size(), static_cast<std::uint8_t>(i + 1));
  }
  test::drop_unused(out.mesh, out.label);
  test::fill_normals(out.mesh);
  return out;
}

Dimensions truth_of(const MadeSkirt& skirt) {
  const double slope = (skirt.hem_radius - skirt.waist_radius) / skirt.slant();
  return {{"waist", kTurn * skirt.waist_radius},
          {"hip", kTurn * (skirt.waist_radius + 0.2 * slope)},
          {"width", kTurn * skirt.hem_radius},
          {"length", skirt.slant()}};
}

Analysis fitted(const Tiers& tiers) {
  AnalyzeOptions options;
  options.method = Method::Joint;
  return analyze(test::scan_of(tiers.mesh),
                 test::templates_of(std::vector<std::string>(tiers.skirts.size(), "skirt")),
                 options);
}

void expect_held(const GarmentAnalysis& skirt, const std::string& name, double truth) {
  const Measurement& m = measured(skirt, name);
  EXPECT_LE(m.low, truth) << skirt.layer << " " << name;
  EXPECT_GE(m.high, truth) << skirt.layer << " " << name;
}

void expect_hidden(const GarmentAnalysis& skirt, const std::string& name, double truth) {
  const Measurement& m = measured(skirt, name);
  EXPECT_FALSE(m.observable) << skirt.layer << " " << name;
  EXPECT_FALSE(m.worn) << skirt.layer << " " << name;
  EXPECT_GT(m.high - m.low, 0.05) << skirt.layer << " " << name;
  expect_held(skirt, name, truth);
}

TEST(Layers, ThreeWorkAsTwoDo) {
  const Tiers tiers = make_tiers({0.72, 0.52, 0.30});
  const Analysis analysis = fitted(tiers);
  ASSERT_EQ(analysis.garments.size(), 3U);
  for (const GarmentAnalysis& skirt : analysis.garments) {
    const Dimensions truth = truth_of(tiers.skirts[static_cast<std::size_t>(skirt.layer - 1)]);
    EXPECT_TRUE(measured(skirt, "width").observable) << skirt.layer;
    EXPECT_NEAR(measured(skirt, "width").worn.value_or(0), truth.at("width"), 0.02) << skirt.layer;
    if (skirt.layer == 1) {
      for (const auto& [name, value] : truth) {
        EXPECT_TRUE(measured(skirt, name).observable) << name;
        EXPECT_NEAR(measured(skirt, name).worn.value_or(0), value, 0.02) << name;
      }
    } else {
      expect_hidden(skirt, "waist", truth.at("waist"));
      expect_hidden(skirt, "length", truth.at("length"));
      expect_hidden(skirt, "hip", truth.at("hip"));
    }
  }
  std::size_t right = 0;
  for (std::size_t v = 0; v < tiers.label.size(); ++v)
    right += analysis.labels[v] == tiers.label[v] ? 1 : 0;
  EXPECT_GT(static_cast<double>(right), 0.96 * static_cast<double>(tiers.label.size()));
}

TEST(Layers, HiddenClothStaysInside) {
  const Tiers tiers = make_tiers({0.72, 0.45});
  const GarmentAnalysis inner = fitted(tiers).garments.at(1);
  std::size_t hidden = 0;
  for (const Vec3& p : inner.draped) {
    if (p.y() < 0.76 || p.y() > 1.0) continue;
    ++hidden;
    // The outer skirt is fitted, and its triangles lie within its circle, to a few millimetres.
    EXPECT_LT(std::hypot(p.x(), p.z()), tiers.skirts[0].radius(p.y()) + 0.004);
  }
  EXPECT_GT(hidden, 50U);
}

}  // namespace
}  // namespace regarment
