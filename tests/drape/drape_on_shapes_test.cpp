// Cloth comes to rest where geometry says it must.
#include <gtest/gtest.h>

#include <numbers>

#include "cloths.h"
#include "drape/drape.h"
#include "garment/find_template.h"
#include "surfaces.h"

namespace regarment {
namespace {

using namespace test;

constexpr double kRadius = 0.15;  // m, of the ball
constexpr double kFacets = 1e-4;  // m, how far a ball of 1 cm triangles lies inside the round one

TEST(Drape, BringsASheetToRestOnABall) {
  const Mesh mesh = ball(kRadius, 0.01);
  Cloth cloth = flat_patch(10, 0.1);
  for (Vec3& x : cloth.positions) x += Vec3(0, 0.17, 0);
  const DrapeOutcome outcome = drape(cloth, closest_on(mesh));
  EXPECT_EQ(outcome.ending, DrapeEnding::CameToRest);
  // The rim must shrink by (0.07 / 0.15)^2 / 6 = 3.6 % at the corners; four springs of 1 cm, that
  // tight, bent by 1 / 15 on the ball, hold off k_a x 4 * 100 * 0.036 * 0.01 / 15 / 4 = 2.4 mm.
  for (const Vec3& x : cloth.positions) EXPECT_NEAR(x.norm(), kRadius, 2.4e-3);
  EXPECT_LT(outcome.mean_distance, 1e-3);
}

// Without friction a sheet slides off a ball but not out of a bowl.
TEST(Drape, LaysASheetIntoABowlByGravityAndContact) {
  Mesh bowl = ball(kRadius, 0.01);
  for (Triangle& t : bowl.triangles) std::swap(t[1], t[2]);
  Cloth cloth = flat_patch(10, 0.1);
  for (Vec3& x : cloth.positions) x += Vec3(0.02, -0.09, 0.01);
  DrapeOptions options;
  options.attraction_stiffness = 0;
  options.gravity = 9.81;
  options.collisions = true;
  options.solver_tolerance = 1e-6;
  options.largest_step = 0.05;
  options.max_steps = 400;
  const DrapeOutcome outcome = drape(cloth, closest_on(bowl), options);
  EXPECT_EQ(outcome.ending, DrapeEnding::CameToRest);
  // A particle alone is pressed in by m g / k; the whole weight on one would press it in by 121 of
  // that. The middle may hang over the bottom where the rim carries: by at most the 3.6 % that the
  // rim would have to shrink by, here 4 mm.
  const double pressed = 121 * 1e-4 * options.gravity / options.contact_stiffness;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& x : cloth.positions) {
    EXPECT_LT(x.norm(), kRadius - options.contact_thickness + pressed);
    EXPECT_GT(x.norm(), kRadius - options.contact_thickness - kFacets - 4e-3);
    middle += x / 121;
  }
  EXPECT_LT(std::hypot(middle.x(), middle.z()), 5e-3);  // it slid to the bottom from 2.2 cm off
}

TEST(Drape, HoldsASheetOffABallByContact) {
  const Mesh mesh = ball(kRadius, 0.01);
  Cloth cloth = flat_patch(10, 0.1);
  for (Vec3& x : cloth.positions) x += Vec3(0, 0.17, 0);
  DrapeOptions options;
  options.collisions = true;
  const DrapeOutcome outcome = drape(cloth, closest_on(mesh), options);
  EXPECT_EQ(outcome.ending, DrapeEnding::CameToRest);
  // The attraction of 4 N/m presses the sheet into a contact of 200 N/m by a fiftieth of the
  // thickness, the tight rim presses its middle in by less than its own 2.4 mm / 50.
  for (const Vec3& x : cloth.positions)
    EXPECT_GT(x.norm(), kRadius + options.contact_thickness * (1 - 1.0 / 50) - kFacets - 1e-4);
}

TEST(Drape, SendsAnUndersideThroughToTheUnderside) {
  Mesh limb;
  add_sheet(1, 0.01, true, limb);
  add_sheet(1, -0.01, false, limb);
  Cloth below = flat_patch(4, 0.08);
  for (Vec3& x : below.positions) x.y() = 0.03;
  for (Triangle& t : below.triangles) std::swap(t[1], t[2]);
  Cloth same = below;
  drape(below, closest_on(limb));
  for (const Vec3& x : below.positions) EXPECT_NEAR(x.y(), -0.01, 1e-4);
  DrapeOptions plain;
  plain.attraction.by_normals = false;
  drape(same, closest_on(limb), plain);
  for (const Vec3& x : same.positions) EXPECT_NEAR(x.y(), 0.01, 1e-4);
}

/// A skirt that is a cylinder, round the y axis, hanging from y = 0.
struct RoundSkirt {
  GarmentTemplate garment = find_template("skirt");
  double girth = 0;
  Pattern pattern;
  Cloth cloth;

  explicit RoundSkirt(double girth_m) : girth(girth_m), pattern(at(girth_m)) {
    const double radius = girth / (2 * std::numbers::pi);
    std::vector<Vec3> of_particle(static_cast<std::size_t>(pattern.particle_count));
    for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
      const bool front = pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[v])];
      const double across = pattern.flat[v].x() / radius;
      const double angle = front ? across : std::numbers::pi - across;
      of_particle[static_cast<std::size_t>(pattern.particle[v])] =
          Vec3(radius * std::sin(angle), -pattern.flat[v].y(), radius * std::cos(angle));
    }
    cloth = make_cloth(pattern, at_vertices(pattern, of_particle));
  }

  /// Takes another girth; the cloth stays where it lies.
  void resize(double girth_m) {
    pattern = at(girth_m);
    update_cloth(pattern, cloth);
  }

 private:
  Pattern at(double girth_m) const {
    Dimensions d = garment.typical();
    d["waist"] = d["hip"] = d["width"] = girth_m;
    d["length"] = 0.5;
    return make_pattern(garment, d, 0.03);
  }
};

constexpr double kGirth = 0.95;

Mesh trunk() { return pillar(kGirth / (2 * std::numbers::pi), -1, 0.5, 0.01); }

TEST(Drape, LeavesAGarmentOfTheRightSizeWhereItIs) {
  const Mesh mesh = trunk();
  RoundSkirt skirt(kGirth);
  const std::vector<Vec3> before = skirt.cloth.positions;
  const DrapeOutcome outcome = drape(skirt.cloth, closest_on(mesh));
  EXPECT_EQ(outcome.ending, DrapeEnding::CameToRest);
  // Sides of 3 cm are chords: 0.02 % shorter than their arcs, 0.2 mm of girth.
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((skirt.cloth.positions[i] - before[i]).norm(), 1e-3) << i;
  EXPECT_LT(outcome.mean_distance, 2e-4);
}

TEST(Drape, LeavesAGarmentOnItsOwnDrape) {
  const Mesh mesh = trunk();
  RoundSkirt skirt(1.06 * kGirth);  // too wide: it finds its folds
  drape(skirt.cloth, closest_on(mesh));
  Mesh own;
  own.positions = skirt.cloth.positions;
  own.triangles = skirt.cloth.triangles;
  const std::vector<Vec3> before = skirt.cloth.positions;
  const DrapeOutcome outcome = drape(skirt.cloth, closest_on(own));
  EXPECT_EQ(outcome.ending, DrapeEnding::CameToRest);
  double sum = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    sum += (skirt.cloth.positions[i] - before[i]).norm();
  // What the springs held against the trunk's pull they now hold against that of the drape.
  EXPECT_LT(sum / static_cast<double>(before.size()), 2e-3);
  EXPECT_LT(outcome.mean_distance, 1e-3);
}

TEST(Drape, ShowsAWrongSizeAsDistance) {
  const Mesh mesh = trunk();
  const ClosestPoint scan = closest_on(mesh);
  RoundSkirt skirt(kGirth);
  const double right = drape(skirt.cloth, scan).mean_distance;
  for (const double factor : {0.9, 0.95, 1.05, 1.1}) {
    RoundSkirt other(kGirth);
    other.resize(factor * kGirth);
    EXPECT_GT(drape(other.cloth, scan).mean_distance, 5 * right) << factor;
  }
}

TEST(Drape, ComesBackAfterAChangeOfSize) {
  const Mesh mesh = trunk();
  const ClosestPoint scan = closest_on(mesh);
  RoundSkirt skirt(kGirth);
  const DrapeOutcome first = drape(skirt.cloth, scan);
  skirt.resize(0.95 * kGirth);
  drape(skirt.cloth, scan);
  skirt.resize(kGirth);
  const DrapeOutcome again = drape(skirt.cloth, scan);
  EXPECT_EQ(again.ending, DrapeEnding::CameToRest);
  EXPECT_NEAR(again.mean_distance, first.mean_distance, 1e-4);
  EXPECT_NEAR(again.mean_stretch, first.mean_stretch, 1e-3);
}

TEST(Drape, RestsOnACloudAsOnASurface) {
  const Mesh mesh = trunk();
  std::vector<Vec3> normals;
  for (const Vec3& p : mesh.positions) normals.push_back(Vec3(p.x(), 0, p.z()).normalized());
  const ClosestPoint cloud{std::span(mesh.positions), std::span(normals)};
  RoundSkirt skirt(kGirth);
  const DrapeOutcome outcome = drape(skirt.cloth, cloud);
  EXPECT_EQ(outcome.ending, DrapeEnding::CameToRest);
  // Points are 1 cm apart: no place of the cylinder is farther than that from one.
  EXPECT_LT(outcome.mean_distance, 0.01);
  // Along the surface points pull to all sides; across it the skirt keeps its girth.
  double off = 0;
  for (const Vec3& x : skirt.cloth.positions)
    off += std::abs(std::hypot(x.x(), x.z()) - kGirth / (2 * std::numbers::pi));
  EXPECT_LT(off / static_cast<double>(skirt.cloth.size()), 1e-3);
}

}  // namespace
}  // namespace regarment
