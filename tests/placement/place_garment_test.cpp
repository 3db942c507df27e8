#include "placement/place_garment.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "garment/find_template.h"
#include "support/limbs.h"
#include "support/made_person.h"

namespace regarment {
namespace {

using test::MadePerson;

constexpr double kWaist = 0.95, kHem = 0.45;

std::map<std::string, LimbView> cylinder_limbs(double radius) {
  test::LimbPlan plan;
  plan.low = 0.2, plan.high = 1.2;
  plan.radius = [radius](double, double) { return radius; };
  LimbView view{test::upright_axis(0, 1.5), test::limb_map(plan, 1, 72, 0.006), {}};
  std::map<std::string, LimbView> limbs;
  limbs.emplace("torso", std::move(view));
  return limbs;
}

void expect_one_place_per_particle(const Pattern& pattern, const std::vector<Vec3>& placed) {
  ASSERT_EQ(placed.size(), pattern.flat.size());
  std::vector<const Vec3*> seen(static_cast<std::size_t>(pattern.particle_count), nullptr);
  for (std::size_t v = 0; v < placed.size(); ++v) {
    ASSERT_TRUE(placed[v].allFinite()) << v;
    const Vec3*& first = seen[static_cast<std::size_t>(pattern.particle[v])];
    if (first == nullptr) first = &placed[v];
    ASSERT_EQ(*first, placed[v]) << v;
  }
}

TEST(PlaceGarment, ASkirtOnACylinderIsACylinderOfTheRightRadius) {
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.03);
  const auto limbs = cylinder_limbs(0.16);
  PlacementTarget target{
      &limbs, {{"waist", std::vector<double>(72, kWaist)}, {"hem", std::vector<double>(72, kHem)}}};
  PlacementOptions options;
  options.clearance = 0.015;
  const std::vector<Vec3> placed = place_garment(pattern, target, options);
  expect_one_place_per_particle(pattern, placed);
  double low = 1e9, high = -1e9;
  for (std::size_t v = 0; v < placed.size(); ++v) {
    // On a side seam both panels' places are averaged, a hair inside the circle.
    EXPECT_NEAR(std::hypot(placed[v].x(), placed[v].z()), 0.175, 1e-4);
    low = std::min(low, placed[v].y()), high = std::max(high, placed[v].y());
    // Heights run down evenly: t is 0 at the waist and the length at the hem.
    const double share = pattern.flat[v].y() / skirt.typical().at("length");
    EXPECT_NEAR(placed[v].y(), kWaist + share * (kHem - kWaist), 1e-9);
    // The front panel lies in front, the back panel behind, the wearer's left on +x.
    if (std::abs(pattern.flat[v].x()) < 0.10) {
      EXPECT_EQ(placed[v].z() > 0,
                pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[v])]);
    }
    if (pattern.flat[v].x() > 0.02) {
      EXPECT_GT(placed[v].x(), 0);
    }
  }
  EXPECT_NEAR(low, kHem, 1e-9);
  EXPECT_NEAR(high, kWaist, 1e-9);
}

TEST(PlaceGarment, FollowsATiltedEdge) {
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.03);
  const auto limbs = cylinder_limbs(0.16);
  std::vector<double> waist;
  for (int j = 0; j < 72; ++j)
    waist.push_back(kWaist + 0.03 * std::cos(limbs.at("torso").map.column_phi(j)));
  PlacementTarget target{&limbs, {{"waist", waist}, {"hem", std::vector<double>(72, kHem)}}};
  const std::vector<Vec3> placed = place_garment(pattern, target);
  for (int v : edge_named(pattern, "waist").vertices) {
    const double phi = std::atan2(placed[v].x(), placed[v].z());
    // Half a column beside its middle at most.
    EXPECT_NEAR(placed[v].y(), kWaist + 0.03 * std::cos(phi), 0.03 * std::numbers::pi / 72 + 1e-9);
  }
}

/// The limbs of a made person without a finder of edges: everything found but the edges.
std::map<std::string, LimbView> person_limbs(const SurfaceSamples& samples, const Body& body,
                                             bool arms) {
  std::map<std::string, LimbView> limbs;
  const auto add = [&](const char* name, const LimbAxis& axis, BodyPart part, double low,
                       double high) {
    std::vector<int> members;
    for (std::size_t s = 0; s < samples.size(); ++s)
      if (body.part[s] == part) members.push_back(static_cast<int>(s));
    LimbMap map = make_limb_map(samples, members, axis, low, high, 0.005, 48);
    limbs.emplace(name, LimbView{axis, std::move(map), std::move(members)});
  };
  add("torso", trunk_axis(body), BodyPart::Trunk, 0.0, body.neck);
  if (!arms) return limbs;
  add("left_arm", arm_axis(body, 0), BodyPart::LeftArm, -0.1, 0.5);
  add("right_arm", arm_axis(body, 1), BodyPart::RightArm, -0.1, 0.5);
  return limbs;
}

TEST(PlaceGarment, PutsASkirtOutsideOfThePersonOnAllSides) {
  const MadePerson person = test::make_person({});
  const SurfaceSamples samples = sample_surface(person.mesh, 0.006);
  const Body body = find_body(samples, MadePerson::kHeight);
  const auto limbs = person_limbs(samples, body, false);
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.03);
  PlacementTarget target{
      &limbs, {{"waist", std::vector<double>(48, 1.03)}, {"hem", std::vector<double>(48, 0.5)}}};
  const std::vector<Vec3> placed = place_garment(pattern, target);
  expect_one_place_per_particle(pattern, placed);
  // The height field leaves out what hardly faces outwards, as in the hollow between the thighs:
  // there a vertex may touch a leg, no more.
  double outside = 0;
  for (const Vec3& p : placed) {
    EXPECT_FALSE(person.holds(p, 0.005)) << p.transpose();
    outside += person.holds(p) ? 0 : 1;
  }
  EXPECT_GT(outside, 0.99 * static_cast<double>(placed.size()));
}

TEST(PlaceGarment, PutsSleevesOnTheirArmsOutsideOfThePerson) {
  const MadePerson person = test::make_person({});
  const SurfaceSamples samples = sample_surface(person.mesh, 0.006);
  const Body body = find_body(samples, MadePerson::kHeight);
  const auto limbs = person_limbs(samples, body, true);
  const GarmentTemplate tshirt = find_template("tshirt");
  const Pattern pattern = make_pattern(tshirt, tshirt.typical(), 0.03);
  PlacementTarget target{&limbs,
                         {{"hem", std::vector<double>(48, 0.75)},
                          {"left_cuff", std::vector<double>(48, 0.15)},
                          {"right_cuff", std::vector<double>(48, 0.15)}}};
  const std::vector<Vec3> placed = place_garment(pattern, target);
  expect_one_place_per_particle(pattern, placed);
  for (const char* name : {"left_cuff", "right_cuff"}) {
    const int side = std::string(name) == "left_cuff" ? 0 : 1;
    const test::Tube& arm = person.tubes[static_cast<std::size_t>(3 + side)];
    for (int v : edge_named(pattern, name).vertices) {
      const Vec3 d = placed[v] - arm.origin;
      const double along = d.dot(arm.axis), off = (d - along * arm.axis).norm();
      // The clearance is 2 cm; the arm's found axis may be 1.5 cm off, its radius a bin's width.
      EXPECT_NEAR(off, arm.at(along).a + 0.02, 0.01) << name;
      EXPECT_FALSE(person.holds(placed[v]));
    }
  }
}

TEST(PlaceGarment, AGarmentAndItsMirrorImageArePlacedAlike) {
  const auto limbs = cylinder_limbs(0.16);
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.03);
  PlacementTarget target{
      &limbs, {{"waist", std::vector<double>(72, kWaist)}, {"hem", std::vector<double>(72, kHem)}}};
  const std::vector<Vec3> placed = place_garment(pattern, target);
  for (const Vec3& p : placed) {
    const Vec3 mirror(-p.x(), p.y(), p.z());
    double nearest = 1e9;
    for (const Vec3& q : placed) nearest = std::min(nearest, (q - mirror).norm());
    ASSERT_LT(nearest, 1e-6) << p.transpose();
  }
}

TEST(PlaceGarment, RefusesWhatItCannotUse) {
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.05);
  const std::map<std::string, LimbView> none;
  EXPECT_THROW(place_garment(pattern, PlacementTarget{&none, {}}), InvalidInput);
  EXPECT_THROW(place_garment(pattern, PlacementTarget{}), InvalidInput);
  PlacementOptions options;
  options.clearance = -0.01;
  const auto limbs = cylinder_limbs(0.16);
  EXPECT_THROW(place_garment(pattern, PlacementTarget{&limbs, {}}, options), InvalidInput);
}

}  // namespace
}  // namespace regarment
