#include "drape/drape.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/error.h"
#include "cloths.h"
#include "surfaces.h"

namespace regarment {
namespace {

using namespace test;

Cloth patch_over_ball() {
  Cloth cloth = flat_patch(10, 0.1);
  for (Vec3& x : cloth.positions) x += Vec3(0.011, 0.17, 0.007);
  return cloth;
}

TEST(Drape, SaysThatItDidNotComeToRest) {
  const Mesh mesh = ball(0.15, 0.01);
  DrapeOptions options;
  options.max_steps = 2;
  Cloth cloth = patch_over_ball();
  const DrapeOutcome outcome = drape(cloth, closest_on(mesh), options);
  EXPECT_EQ(outcome.ending, DrapeEnding::StepLimit);
  EXPECT_EQ(outcome.steps, 2);
}

TEST(Drape, ReportsWhatTheClothShows) {
  const Mesh mesh = ball(0.15, 0.01);
  const ClosestPoint scan = closest_on(mesh);
  Cloth cloth = patch_over_ball();
  const DrapeOutcome outcome = drape(cloth, scan);
  EXPECT_EQ(outcome.mean_stretch, mean_stretch(cloth));
  EXPECT_EQ(outcome.mean_distance, mean_distance(attract(cloth, scan, {})));
  double fastest = 0;
  for (const Vec3& v : cloth.velocities) fastest = std::max(fastest, v.norm());
  EXPECT_DOUBLE_EQ(outcome.largest_speed, fastest);
}

TEST(Drape, GivesTheSameBytesAgain) {
  const Mesh mesh = ball(0.15, 0.01);
  Cloth one = patch_over_ball(), two = patch_over_ball();
  const DrapeOutcome a = drape(one, closest_on(mesh)), b = drape(two, closest_on(mesh));
  EXPECT_EQ(one.positions, two.positions);
  EXPECT_EQ(one.velocities, two.velocities);
  EXPECT_EQ(a.steps, b.steps);
}

TEST(Drape, MirrorsWithItsInput) {
  Mesh mesh = ball(0.15, 0.01), mirrored_mesh = mesh;
  for (Vec3& p : mirrored_mesh.positions) p.x() = -p.x();
  for (Triangle& t : mirrored_mesh.triangles) std::swap(t[1], t[2]);
  Cloth cloth = patch_over_ball();
  std::vector<Vec3> flat = flat_patch(10, 0.1).positions;
  std::vector<Triangle> triangles = cloth.triangles;
  for (Vec3& p : flat) p.x() = -p.x();
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
  Cloth mirrored = make_test_cloth(flat, triangles);
  for (std::size_t i = 0; i < cloth.size(); ++i)
    mirrored.positions[i] = Vec3(-1, 1, 1).cwiseProduct(cloth.positions[i]);
  drape(cloth, closest_on(mesh));
  drape(mirrored, closest_on(mirrored_mesh));
  for (std::size_t i = 0; i < cloth.size(); ++i)
    EXPECT_LT((mirrored.positions[i] - Vec3(-1, 1, 1).cwiseProduct(cloth.positions[i])).norm(),
              1e-6)  // m: sums run in another order, and steps pass rounding on
        << i;
}

TEST(Drape, SurvivesAWildStart) {
  const Mesh mesh = ball(0.15, 0.01);
  const ClosestPoint scan = closest_on(mesh);
  const auto ends_finite = [&](const std::function<void(Cloth&)>& spoil) {
    Cloth cloth = flat_patch(6, 0.1);
    spoil(cloth);
    DrapeOptions options;
    options.max_steps = 20;
    options.collisions = true;
    const DrapeOutcome outcome = drape(cloth, scan, options);
    for (const Vec3& x : cloth.positions) EXPECT_TRUE(x.allFinite());
    EXPECT_TRUE(std::isfinite(outcome.mean_distance) && std::isfinite(outcome.mean_stretch));
  };
  ends_finite([](Cloth& c) {
    for (Vec3& x : c.positions) x.setZero();
  });
  ends_finite([](Cloth& c) {
    for (Vec3& x : c.positions) x *= 100;
  });
  ends_finite([](Cloth& c) {
    for (Vec3& x : c.positions) x += Vec3(10, -20, 5);
  });
  ends_finite([](Cloth& c) {
    for (Vec3& v : c.velocities) v = Vec3(1e6, 1e7, -1e6);
  });
  ends_finite([](Cloth& c) {
    for (double& m : c.masses) m = 1e-12;
  });
  ends_finite([](Cloth& c) { shake(c, 0.3, 100, 41); });
}

TEST(Drape, MovesNoParticleFartherThanAllowed) {
  const Mesh mesh = ball(0.15, 0.01);
  DrapeOptions options;
  options.largest_move = 0.002;
  options.max_steps = 1;
  Cloth cloth = patch_over_ball();
  for (Vec3& v : cloth.velocities) v = Vec3(0, 1000, 0);
  const std::vector<Vec3> before = cloth.positions;
  drape(cloth, closest_on(mesh), options);
  for (std::size_t i = 0; i < cloth.size(); ++i)
    EXPECT_LE((cloth.positions[i] - before[i]).norm(), 0.002 + 1e-12);
}

TEST(Drape, StopsWhenAsked) {
  const Mesh mesh = ball(0.15, 0.01);
  Cloth cloth = patch_over_ball();
  int steps = 0;
  const Progress progress([&](std::string_view, double) { return ++steps < 3; });
  EXPECT_THROW(drape(cloth, closest_on(mesh), {}, progress), Stopped);
  EXPECT_EQ(steps, 3);
}

TEST(Drape, RefusesWhatItCannotDrape) {
  const Mesh mesh = ball(0.15, 0.01);
  Cloth none;
  EXPECT_THROW(drape(none, closest_on(mesh)), InvalidInput);
  Cloth cloth = patch_over_ball();
  const Mesh nothing;
  EXPECT_THROW(drape(cloth, closest_on(nothing)), InvalidInput);
  cloth.positions[5].z() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(drape(cloth, closest_on(mesh)), InvalidInput);
}

TEST(DrapeOptions, RefusesHostileValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  using Field = double DrapeOptions::*;
  const auto refused = [](Field field, double value) {
    DrapeOptions options;
    options.*field = value;
    EXPECT_THROW(options.check(), InvalidInput) << value;
  };
  EXPECT_NO_THROW(DrapeOptions().check());
  for (const Field field :
       {&DrapeOptions::spring_stiffness, &DrapeOptions::spring_damping,
        &DrapeOptions::bending_stiffness, &DrapeOptions::bending_damping,
        &DrapeOptions::attraction_stiffness, &DrapeOptions::attraction_grip,
        &DrapeOptions::contact_stiffness, &DrapeOptions::contact_thickness,
        &DrapeOptions::first_step, &DrapeOptions::least_step, &DrapeOptions::largest_step,
        &DrapeOptions::largest_move, &DrapeOptions::largest_stretch_change,
        &DrapeOptions::solver_tolerance, &DrapeOptions::rest_speed,
        &DrapeOptions::rest_distance_change, &DrapeOptions::rest_stretch_change})
    for (const double value : {-1.0, nan, inf}) refused(field, value);
  for (const double value : {nan, inf}) refused(&DrapeOptions::gravity, value);
  refused(&DrapeOptions::attraction_grip, 1.5);
  refused(&DrapeOptions::first_step, 1.0);  // longer than the largest
  refused(&DrapeOptions::least_step, 0.1);  // longer than the first
  refused(&DrapeOptions::solver_tolerance, 1.0);
  DrapeOptions options;
  options.max_steps = 0;
  EXPECT_THROW(options.check(), InvalidInput);
  options = {};
  options.attraction.normal_angle = -1;
  EXPECT_THROW(options.check(), InvalidInput);
}

TEST(DrapeOptions, NamesTheFieldAndItsValue) {
  DrapeOptions options;
  options.spring_damping = -3;
  try {
    options.check();
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("spring_damping"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("-3"), std::string::npos);
  }
}

}  // namespace
}  // namespace regarment
