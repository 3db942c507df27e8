// Who is a person and which way up, over poses, bodies and damage; and what is no person.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "base/error.h"
#include "scan/cone_person.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

using namespace test;

struct Pose {
  const char* name;
  PersonShape shape;
};

void PrintTo(const Pose& pose, std::ostream* out) { *out << pose.name; }

class Person : public testing::TestWithParam<Pose> {};

/// Lying along x, feet first, turned about the body's own axis: nothing in the file helps.
const Eigen::Matrix3d kLying =
    Eigen::AngleAxisd(-1.5707963267948966, Vec3::UnitZ()).toRotationMatrix() *
    Eigen::AngleAxisd(0.6, Vec3::UnitY()).toRotationMatrix();

void expect_right_way_round(const Scan& scan) {
  EXPECT_EQ(scan.facts.up, "+x");
  const Vec3 front = scan.file_from_body.linear().col(2).normalized();
  EXPECT_GT(front.dot(kLying.col(2)), 0.9976);  // 4 degrees
  EXPECT_EQ(scan.facts.units, "m");
}

TEST_P(Person, IsFoundAsAMesh) {
  expect_right_way_round(make_scan(moved(made_person(GetParam().shape), kLying)));
}

TEST_P(Person, IsFoundAsACloud) {
  Mesh cloud = made_cloud(GetParam().shape, 20000, 0.001);
  cloud.normals.clear();
  expect_right_way_round(make_scan(moved(cloud, kLying)));
}

INSTANTIATE_TEST_SUITE_P(
    Poses, Person,
    testing::Values(Pose{"relaxed", {}}, Pose{"arms_down", {.arm_angle = -78}},
                    Pose{"t_pose", {.arm_angle = 0}}, Pose{"arms_raised", {.arm_angle = 40}},
                    Pose{"arms_overhead", {.arm_angle = 80}}, Pose{"heavy", {.girth = 1.35}},
                    Pose{"slim", {.girth = 0.75}}, Pose{"child", {.head = 1.8}},
                    Pose{"walking", {.stride = 0.4}}, Pose{"knee_skirt", {.skirt_hem = 0.5}},
                    Pose{"wide_skirt", {.skirt_hem = 0.3, .skirt_radius = 0.4}},
                    Pose{"skirt_to_the_floor", {.skirt_hem = 0.0}},
                    Pose{"t_pose_skirt", {.arm_angle = 0, .skirt_hem = 0.4}},
                    Pose{"no_head", {.has_head = false}}, Pose{"no_feet", {.has_feet = false}}),
    [](const auto& test) { return test.param.name; });

TEST(PersonFindings, SayWhatIsMissing) {
  const Scan scan = make_scan(made_person({.has_head = false}));
  ASSERT_EQ(scan.facts.findings.size(), 1u);
  EXPECT_EQ(scan.facts.findings[0].code, "missing_head");
}

TEST(PersonFindings, AreSilentForAPlainPerson) {
  EXPECT_TRUE(make_scan(made_person()).facts.findings.empty());
}

TEST(TiltedScan, HasAFreeUpDirection) {
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(0.6, Vec3(1, 0, 0.5).normalized()).toRotationMatrix();
  const Scan scan = make_scan(moved(made_person(), tilt));
  EXPECT_EQ(scan.facts.up, "free");
  EXPECT_GT(scan.file_from_body.linear().col(1).normalized().dot(tilt.col(1)),
            0.9986);  // 3 degrees
  EXPECT_GT(scan.file_from_body.linear().col(2).normalized().dot(tilt.col(2)), 0.9976);
  ASSERT_FALSE(scan.facts.findings.empty());
  EXPECT_EQ(scan.facts.findings[0].code, "tilted");
}

Mesh random_points(std::size_t count, const Vec3& size) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform;
  Mesh mesh;
  while (mesh.positions.size() < count) {
    mesh.positions.emplace_back(size.x() * uniform(random), size.y() * uniform(random),
                                size.z() * uniform(random));
  }
  return mesh;
}

Mesh chair() {
  Mesh mesh = moved(made_box({0.45, 0.04, 0.45}), Eigen::Matrix3d::Identity(), 1, {0, 0.45, 0});
  append(mesh, moved(made_box({0.45, 0.5, 0.03}), Eigen::Matrix3d::Identity(), 1, {0, 0.45, 0}));
  for (const double x : {0.0, 0.41}) {
    for (const double z : {0.0, 0.41}) {
      append(mesh, moved(made_box({0.04, 0.45, 0.04}), Eigen::Matrix3d::Identity(), 1, {x, 0, z}));
    }
  }
  return mesh;
}

Mesh points_at_one_place() {
  Mesh mesh = random_points(1, {1, 1, 1});
  for (int i = 0; i < 1000; ++i) mesh.positions.push_back(mesh.positions[0] * (1 + 1e-15 * i));
  return mesh;
}

struct Thing {
  const char* name;
  Mesh (*make)();
};

void PrintTo(const Thing& thing, std::ostream* out) { *out << thing.name; }

class NoPerson : public testing::TestWithParam<Thing> {};

TEST_P(NoPerson, IsRefusedWithAReason) {
  try {
    const Scan scan = make_scan(GetParam().make());
    FAIL() << "taken for a person, up " << scan.facts.up;
  } catch (const NoPersonError& error) {
    EXPECT_EQ(error.exit_status(), 3);
    EXPECT_GT(std::string(error.what()).size(), 40u);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Things, NoPerson,
    testing::Values(Thing{"empty", [] { return Mesh(); }},
                    Thing{"three_points",
                          [] {
                            return random_points(3, {1, 1, 1});
                          }},
                    Thing{"tiny_cloud",
                          [] {
                            return random_points(50, {1, 1, 1});
                          }},
                    Thing{"one_place", points_at_one_place},
                    Thing{"cube",
                          [] {
                            return made_box({1, 1, 1});
                          }},
                    Thing{"coarse_cube",
                          [] {
                            return made_box({1, 1, 1}, 2);
                          }},
                    Thing{"cube_in_mm",
                          [] {
                            return made_box({1000, 1000, 1000}, 50);
                          }},
                    Thing{"cube_cloud",
                          [] {
                            return cloud_of(made_box({1, 1, 1}, 0.02));
                          }},
                    Thing{"sphere", [] { return made_sphere(0.9); }},
                    Thing{"plane",
                          [] {
                            return made_box({1, 1.7, 0.0001});
                          }},
                    Thing{"box_of_human_size",
                          [] {
                            return made_box({0.45, 1.75, 0.28});
                          }},
                    Thing{"pillar",
                          [] {
                            return made_box({0.25, 1.75, 0.25});
                          }},
                    Thing{"chair", chair},
                    Thing{"random_points",
                          [] {
                            return random_points(20000, {1.7, 1.7, 1.7});
                          }},
                    Thing{"random_points_of_human_size",
                          [] {
                            return random_points(50000, {0.5, 1.75, 0.3});
                          }},
                    Thing{"kilometres",
                          [] { return moved(made_person(), Eigen::Matrix3d::Identity(), 1e6); }},
                    Thing{"no_unit_fits",
                          [] { return moved(made_person(), Eigen::Matrix3d::Identity(), 6.0); }}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace regarment
