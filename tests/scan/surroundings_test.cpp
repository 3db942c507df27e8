// What stands about a person changes nothing of how the person is understood, and is said.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "scan/cone_person.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

using namespace test;

/// A flat square about the origin, `half` from the middle to each side.
Mesh made_floor(double half, double edge = 0.03) {
  const int steps = static_cast<int>(std::ceil(2 * half / edge));
  Mesh mesh;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      mesh.positions.emplace_back(half * (2.0 * i / steps - 1), 0, half * (2.0 * j / steps - 1));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (steps + 1) + j); };
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return mesh;
}

Mesh shifted(Mesh mesh, const Vec3& shift) {
  return moved(std::move(mesh), Eigen::Matrix3d::Identity(), 1.0, shift);
}

Mesh made_wall(double half) {
  const Eigen::Matrix3d upright = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()).toRotationMatrix();
  return moved(made_floor(half), upright, 1.0, Vec3(0, half, -0.44));
}

Mesh made_post(const Vec3& foot) { return shifted(made_box(Vec3(0.06, 2.1, 0.06), 0.02), foot); }

std::vector<std::string> codes_of(const Scan& scan) {
  std::vector<std::string> codes;
  for (const Finding& finding : scan.facts.findings) codes.push_back(finding.code);
  return codes;
}

using Codes = std::vector<std::string>;

struct Surrounded {
  const char* name;
  Codes codes;
  Mesh (*surroundings)();
  std::size_t near_soles;  // vertices of the person that may go with a floor
};

void PrintTo(const Surrounded& surrounded, std::ostream* out) { *out << surrounded.name; }

class SurroundedPerson : public testing::TestWithParam<Surrounded> {};

/// The person of `scan`, whose vertices come first, must be as `alone`.
void expect_same_person(const Scan& scan, const Scan& alone, std::size_t may_go) {
  EXPECT_EQ(scan.facts.units, alone.facts.units);
  EXPECT_EQ(scan.facts.up, alone.facts.up);
  EXPECT_EQ(scan.facts.front, alone.facts.front);
  EXPECT_NEAR(scan.facts.height, alone.facts.height, 0.008);
  const Vec3 front = scan.file_from_body.linear().col(2).normalized();
  EXPECT_GT(front.dot(alone.file_from_body.linear().col(2).normalized()), 0.9986);  // 3 degrees
  std::size_t lost = 0;
  for (std::size_t v = 0; v < alone.outlier.size(); ++v) {
    lost += scan.outlier[v];
    EXPECT_NEAR(scan.mesh.positions[v].y(), alone.mesh.positions[v].y(), 0.008);
  }
  EXPECT_LE(lost, may_go);
}

TEST_P(SurroundedPerson, IsTheSamePersonAndSaysWhatIsAround) {
  const Surrounded& how = GetParam();
  for (const bool z_up_millimetres : {false, true}) {
    Mesh person = made_person({.skirt_hem = 0.5}), all = person;
    append(all, how.surroundings());
    if (z_up_millimetres) {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()).toRotationMatrix() *
                                   Eigen::AngleAxisd(0.3, Vec3::UnitY()).toRotationMatrix();
      person = moved(person, turn, 1000, Vec3(300, -200, 90));
      all = moved(all, turn, 1000, Vec3(300, -200, 90));
    }
    const Scan alone = make_scan(person), scan = make_scan(all);
    EXPECT_TRUE(alone.facts.findings.empty());
    EXPECT_EQ(codes_of(scan), how.codes);
    expect_same_person(scan, alone, how.near_soles);
    const std::size_t first = person.positions.size();
    std::size_t kept = 0;
    for (std::size_t v = first; v < all.positions.size(); ++v) kept += scan.outlier[v] == 0 ? 1 : 0;
    EXPECT_LE(kept, (all.positions.size() - first) / 100);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, SurroundedPerson,
    testing::Values(
        Surrounded{"floor_under_the_feet", {"floor"}, [] { return made_floor(0.8); }, 200},
        Surrounded{"small_mat", {"floor"}, [] { return made_floor(0.4, 0.02); }, 200},
        Surrounded{"large_floor", {"floor"}, [] { return made_floor(2.5, 0.05); }, 200},
        Surrounded{"wall", {"wall"}, [] { return made_wall(1.2); }, 0},
        Surrounded{"floor_and_wall",
                   {"floor"},
                   [] {
                     Mesh room = made_floor(1.2);
                     append(room, made_wall(1.2));
                     return room;
                   },
                   200},
        Surrounded{"posts",
                   {"post"},
                   [] {
                     Mesh posts = made_post(Vec3(0.9, 0, 0.4));
                     append(posts, made_post(Vec3(-0.9, 0, 0.4)));
                     append(posts, made_post(Vec3(0.7, 0, -0.8)));
                     append(posts, made_post(Vec3(-0.7, 0, -0.8)));
                     return posts;
                   },
                   0},
        Surrounded{"posts_on_a_floor",
                   {"floor", "post"},
                   [] {
                     Mesh room = made_floor(1.0);
                     append(room, made_post(Vec3(0.8, 0, 0.4)));
                     append(room, made_post(Vec3(-0.8, 0, 0.4)));
                     return room;
                   },
                   200},
        Surrounded{"one_near_post", {"post"}, [] { return made_post(Vec3(0.45, 0, 0.45)); }, 0},
        Surrounded{"island",
                   {"island"},
                   [] { return shifted(made_box(Vec3(0.3, 0.4, 0.2)), Vec3(0.8, 0, -0.2)); },
                   0},
        Surrounded{"island_far_away",
                   {"island"},
                   [] { return shifted(made_box(Vec3(0.3, 0.4, 0.2)), Vec3(70, 3, -20)); },
                   0}),
    [](const auto& test) { return test.param.name; });

TEST(Surroundings, AreSeenInACloudWithNoise) {
  Mesh cloud = cloud_of(made_cloud({}, 30000, 0.001));
  cloud.normals.clear();
  const Scan alone = make_scan(cloud);
  const std::size_t real = cloud.positions.size();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> across(-0.9, 0.9);
  std::normal_distribution<double> noise(0, 0.002);
  for (int i = 0; i < 20000; ++i) {
    cloud.positions.emplace_back(across(random), noise(random), across(random));
  }
  const Scan scan = make_scan(cloud);
  EXPECT_EQ(codes_of(scan)[0], "floor");
  expect_same_person(scan, alone, real / 50);
}

TEST(Surroundings, AFloorSeenAskewIsTheGround) {
  // The floor decides where the feet stand also where no axis is upright.
  Mesh all = made_person();
  append(all, made_floor(0.8));
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(0.6, Vec3(1, 0, 0.5).normalized()).toRotationMatrix();
  const Scan scan = make_scan(moved(all, tilt));
  EXPECT_EQ(scan.facts.up, "free");
  EXPECT_GT(scan.file_from_body.linear().col(1).normalized().dot(tilt.col(1)), 0.9986);
  EXPECT_NEAR(scan.facts.height, 1.74, 0.02);
}

TEST(Surroundings, SolesHemsAndOutspreadArmsAreNone) {
  for (const PersonShape& shape :
       {PersonShape{.arm_angle = 0}, PersonShape{.skirt_hem = 0.0, .skirt_radius = 0.5},
        PersonShape{.stride = 0.4}, PersonShape{.arm_angle = 80, .skirt_hem = 0.3}}) {
    EXPECT_EQ(make_scan(made_person(shape)).facts.outliers, 0u);
  }
}

}  // namespace
}  // namespace regarment
