#include "placement/body.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/made_person.h"

namespace regarment {
namespace {

using test::MadePerson;
using test::make_person;
using test::PersonPlan;

constexpr double kSpacing = 0.006;
constexpr double kSlice =
    0.01;  // m; in a random cloud one slice more or less shows the gap of an armpit

SurfaceSamples samples_of(const Mesh& mesh) { return sample_surface(mesh, kSpacing); }

struct Pose {
  const char* name;
  double left, right;  // radians from straight down
  double tolerance;    // m, of the armpits
};

// An arm that leaves the trunk at an angle of t from it is 24 mm away (two cells of a slice) only
// 24 mm / tan t below the armpit; for steep arms that is more than the 2 cm allowed otherwise.
constexpr Pose kPoses[] = {{"A", 0.8, 0.8, 0.02},
                           {"T", 1.57, 1.57, 0.02},
                           {"wide", 1.15, 1.15, 0.02},
                           {"low", 0.42, 0.42, 0.055},
                           {"one_low_one_wide", 0.45, 1.1, 0.055}};

class FindBody : public testing::TestWithParam<Pose> {};

void expect_landmarks(const MadePerson& person, const Body& body, double armpit_tolerance) {
  EXPECT_NEAR(body.fork, MadePerson::kFork, 0.02);
  EXPECT_NEAR(body.neck, MadePerson::kNeck, 0.02);
  for (int side = 0; side < 2; ++side) {
    EXPECT_NEAR(body.armpit[side], person.armpit(side), armpit_tolerance) << "side " << side;
    const double trunk_side = person.tubes[0].at(person.armpit(side)).b * (side == 0 ? 1 : -1);
    EXPECT_NEAR(body.armpit_x[side], trunk_side, 0.02) << "side " << side;
    ASSERT_TRUE(body.arms[side].present()) << "side " << side;
  }
}

/// Largest distance of an arm's found axis from the true one, between the armpit's plane and the
/// hand.
double axis_error(const MadePerson& person, const Body& body, int side) {
  const test::Tube& arm = person.tubes[static_cast<std::size_t>(3 + side)];
  double worst = 0;
  for (const Vec3& p : body.arms[side].points) {
    const Vec3 d = p - arm.origin;
    const double t = d.dot(arm.axis);
    if (t < 0.1 || t > arm.high() - 0.05) continue;
    worst = std::max(worst, (d - t * arm.axis).norm());
  }
  return worst;
}

TEST_P(FindBody, FindsTheLandmarksOfAMesh) {
  const Pose& pose = GetParam();
  PersonPlan plan;
  plan.left_arm = pose.left, plan.right_arm = pose.right;
  const MadePerson person = make_person(plan);
  const Body body = find_body(samples_of(person.mesh), MadePerson::kHeight);
  expect_landmarks(person, body, pose.tolerance);
  for (int side = 0; side < 2; ++side) {
    EXPECT_LT(axis_error(person, body, side), 0.015) << "side " << side;
    // The axis ends near the fingertips.
    const test::Tube& arm = person.tubes[static_cast<std::size_t>(3 + side)];
    EXPECT_LT((body.arms[side].points.back() - arm.point(arm.high(), 0, 0)).norm(), 0.05);
  }
}

TEST_P(FindBody, FindsTheLandmarksOfACloud) {
  const Pose& pose = GetParam();
  PersonPlan plan;
  plan.left_arm = pose.left, plan.right_arm = pose.right;
  const MadePerson person = make_person(plan);
  const Mesh cloud = test::cloud_of(person.mesh, 0.005, 3);
  const Body body = find_body(samples_of(cloud), MadePerson::kHeight);
  expect_landmarks(person, body, pose.tolerance + kSlice);
}

TEST_P(FindBody, SaysOfEachSampleWhatItBelongsTo) {
  const Pose& pose = GetParam();
  PersonPlan plan;
  plan.left_arm = pose.left, plan.right_arm = pose.right;
  const MadePerson person = make_person(plan);
  const SurfaceSamples samples = samples_of(person.mesh);
  const Body body = find_body(samples, MadePerson::kHeight);
  ASSERT_EQ(body.part.size(), samples.size());
  std::size_t wrong = 0, scored = 0;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const Vec3& p = samples.positions[s];
    // Near the shoulder the border between arm and trunk is a matter of taste.
    BodyPart expected = BodyPart::Trunk;
    for (int side = 0; side < 2; ++side) {
      const test::Tube& arm = person.tubes[static_cast<std::size_t>(3 + side)];
      const double along = (p - arm.origin).dot(arm.axis);
      const bool on_arm = (p - arm.origin - along * arm.axis).norm() < 0.06;
      if (on_arm && along > 0.15) expected = side == 0 ? BodyPart::LeftArm : BodyPart::RightArm;
      if (on_arm && along <= 0.15 && along > -0.05) expected = BodyPart::Loose;
    }
    if (expected == BodyPart::Loose || std::abs(p.y() - 1.36) < 0.10) continue;
    if (std::abs(p.x()) > 0.14 && expected == BodyPart::Trunk && p.y() > 0.95) continue;
    ++scored;
    wrong += body.part[s] != expected;
  }
  EXPECT_GT(scored, samples.size() / 2);
  EXPECT_LT(static_cast<double>(wrong), 0.01 * static_cast<double>(scored));
}

INSTANTIATE_TEST_SUITE_P(Poses, FindBody, testing::ValuesIn(kPoses),
                         [](const auto& pose) { return std::string(pose.param.name); });

TEST(FindBodyMirror, AMirroredPersonGivesTheMirroredResult) {
  PersonPlan plan;
  plan.left_arm = 0.6, plan.right_arm = 1.0;
  const Mesh mesh = make_person(plan).mesh;
  const Body body = find_body(samples_of(mesh), MadePerson::kHeight);
  const Body mirror = find_body(samples_of(test::mirrored(mesh)), MadePerson::kHeight);
  // Cells of slices and voxels are not symmetric: a level or a cell more or less.
  EXPECT_NEAR(body.fork, mirror.fork, 0.011);
  EXPECT_NEAR(body.neck, mirror.neck, 0.011);
  EXPECT_NEAR(body.shoulder, mirror.shoulder, 0.011);
  for (int side = 0; side < 2; ++side) {
    EXPECT_NEAR(body.armpit[side], mirror.armpit[1 - side], 0.011);
    EXPECT_NEAR(body.armpit_x[side], -mirror.armpit_x[1 - side], 0.005);
    const std::vector<Vec3>&a = body.arms[side].points, &b = mirror.arms[1 - side].points;
    ASSERT_FALSE(a.empty() || b.empty());
    const Vec3 root = a.front().cwiseProduct(Vec3(-1, 1, 1)),
               end = a.back().cwiseProduct(Vec3(-1, 1, 1));
    EXPECT_LT((root - b.front()).norm(), 0.02);
    EXPECT_LT((end - b.back()).norm(), 0.04);
  }
  ASSERT_EQ(body.trunk.size(), mirror.trunk.size());
  for (std::size_t i = 0; i < body.trunk.size(); ++i) {
    EXPECT_EQ(body.trunk[i].present, mirror.trunk[i].present) << i;
    if (body.trunk[i].present && mirror.trunk[i].y < 1.0) {
      EXPECT_NEAR(body.trunk[i].x_min, -mirror.trunk[i].x_max, 1e-9) << i;
    }
  }
}

TEST(FindBodySkirt, TheHemIsWhereTheLegsJoinUnderASkirt) {
  PersonPlan plan;
  plan.skirt.emplace();
  const MadePerson person = make_person(plan);
  const Body body = find_body(samples_of(person.mesh), MadePerson::kHeight);
  EXPECT_NEAR(body.fork, plan.skirt->hem_y, 0.02);
  EXPECT_NEAR(body.neck, MadePerson::kNeck, 0.02);
}

TEST(FindBodyHoles, TenPercentOfTheSurfaceMissingMovesNothing) {
  const MadePerson person = make_person({});
  Mesh cloud = test::cloud_of(person.mesh, 0.005, 4);
  // A strip missing from every height, as a column of scanners leaves it, and a lost hand.
  Mesh kept;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    const Vec3& p = cloud.positions[i];
    const bool strip = p.z() < 0 && std::abs(p.x() - 0.09) < 0.02;
    if (strip || p.y() < 0.02) continue;
    kept.positions.push_back(p);
    kept.normals.push_back(cloud.normals[i]);
  }
  ASSERT_LT(kept.positions.size(), 0.97 * static_cast<double>(cloud.positions.size()));
  expect_landmarks(person, find_body(samples_of(kept), MadePerson::kHeight), 0.02 + kSlice);
}

TEST(FindBodyErrors, WhatHasNoTrunkIsNoPerson) {
  Mesh pole;  // a thin upright pole
  test::Tube tube;
  tube.stations = {{0.0, 0.01, 0.01}, {1.7, 0.01, 0.01}};
  test::add_tube(tube, 0.008, {}, pole);
  test::fill_normals(pole);
  EXPECT_THROW(find_body(samples_of(pole), 1.7), NoPersonError);
  EXPECT_THROW(find_body(SurfaceSamples{}, 1.7), NoPersonError);
}

TEST(BodyLandmarks, NamesOnlyWhatIsThere) {
  Body body;
  body.height = 1.7;
  EXPECT_EQ(body.landmarks(), (std::map<std::string, double>{{"height", 1.7}}));
  body.fork = 0.8, body.neck = 1.45, body.armpit[1] = 1.3;
  EXPECT_EQ(body.landmarks(),
            (std::map<std::string, double>{
                {"height", 1.7}, {"crotch", 0.8}, {"neck", 1.45}, {"right_armpit", 1.3}}));
}

}  // namespace
}  // namespace regarment
