#include "scan/make_scan.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <random>

#include "base/error.h"
#include "geometry/point_tree.h"
#include "scan/cone_person.h"

namespace regarment {
namespace {

using test::cloud_of;
using test::made_cloud;
using test::made_person;
using test::moved;
using test::PersonShape;

constexpr double kDegree = 3.14159265358979323846 / 180;

/// The 24 ways to lay a right-handed frame along the axes of another.
std::vector<Eigen::Matrix3d> quarter_turns() {
  std::vector<Eigen::Matrix3d> turns;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (const double sx : {1.0, -1.0}) {
        for (const double sy : {1.0, -1.0}) {
          if (x == y) continue;
          Eigen::Matrix3d turn;
          turn.col(0) = sx * Vec3::Unit(x);
          turn.col(1) = sy * Vec3::Unit(y);
          turn.col(2) = turn.col(0).cross(turn.col(1));
          turns.push_back(turn);
        }
      }
    }
  }
  return turns;
}

Eigen::Matrix3d yaw(double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitY()).toRotationMatrix();
}

std::string axis_name(const Vec3& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return std::string(direction[axis] < 0 ? "-" : "+") + "xyz"[axis];
}

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) / kDegree;
}

Vec3 front_in_file(const Scan& scan) { return scan.file_from_body.linear().col(2); }
Vec3 up_in_file(const Scan& scan) { return scan.file_from_body.linear().col(1); }

/// One turn of the file and one unit, which all must give the same person.
struct Turned {
  int quarter_turn;
  double yaw_degrees;
  const char* unit;
  double units_per_metre;
};

class TurnedPerson : public testing::TestWithParam<Turned> {};

TEST_P(TurnedPerson, StandsTheSameWay) {
  const auto [quarter_turn, yaw_degrees, unit, units_per_metre] = GetParam();
  const Mesh person = made_person();
  const Eigen::Matrix3d turn = quarter_turns()[quarter_turn] * yaw(yaw_degrees);
  const Vec3 shift(0.7 * units_per_metre, -3.1 * units_per_metre, 1.3 * units_per_metre);
  const Scan scan = make_scan(moved(person, turn, units_per_metre, shift));

  EXPECT_EQ(scan.facts.units, unit);
  EXPECT_TRUE(scan.facts.units_guessed && scan.facts.up_guessed && scan.facts.front_guessed);
  EXPECT_EQ(scan.facts.up, axis_name(turn.col(1)));
  EXPECT_LT(degrees_between(up_in_file(scan), turn.col(1)), 1e-6);
  EXPECT_LT(degrees_between(front_in_file(scan), turn.col(2)), 3.0);
  EXPECT_GT(scan.facts.front_confidence, 0.95);
  EXPECT_NEAR(scan.facts.height, 1.74, 0.01);  // nearly flat parts of the skull, 1 cm of facets
  // A metre of the body frame is a metre of the person, and the floor is under the feet.
  ASSERT_EQ(scan.mesh.positions.size(), person.positions.size());
  double lowest = 1;
  for (std::size_t v = 0; v < person.positions.size(); ++v) {
    lowest = std::min(lowest, scan.mesh.positions[v].y());
    EXPECT_NEAR(scan.mesh.positions[v].y(), person.positions[v].y(), 0.005);
    EXPECT_NEAR((scan.mesh.positions[v] - scan.mesh.positions[0]).norm(),
                (person.positions[v] - person.positions[0]).norm(), 1e-9);
    const Vec3 back = scan.file_from_body * scan.mesh.positions[v];
    const Vec3 file = units_per_metre * (turn * person.positions[v]) + shift;
    EXPECT_LT((back - file).norm(), 1e-9 * units_per_metre);
  }
  EXPECT_NEAR(lowest, 0.0, 0.005);
}

std::vector<Turned> all_turns() {
  const std::array<std::pair<const char*, double>, 4> units = {
      {{"m", 1.0}, {"cm", 100.0}, {"mm", 1000.0}, {"inch", 1 / 0.0254}}};
  std::vector<Turned> turns;
  for (int i = 0; i < 24; ++i) {
    for (const double degrees : {0.0, 17.0, 45.0, -100.0}) {
      const auto& [name, scale] = units[turns.size() % 3 == 0 ? 2 : turns.size() / 3 % 4];
      turns.push_back({i, degrees, name, scale});
    }
  }
  return turns;
}

INSTANTIATE_TEST_SUITE_P(AllTurns, TurnedPerson, testing::ValuesIn(all_turns()));

TEST(MakeScan, DoesNotDependOnTheOrderOfVertices) {
  const Mesh ordered = cloud_of(made_cloud({}, 20000, 0.0005));
  std::vector<std::size_t> order(ordered.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(3);
  std::shuffle(order.begin(), order.end(), random);
  Mesh shuffled;
  for (const std::size_t i : order) shuffled.positions.push_back(ordered.positions[i]);

  Mesh plain;
  plain.positions = ordered.positions;
  const Scan one = make_scan(plain), other = make_scan(shuffled);
  EXPECT_LT((one.file_from_body.matrix() - other.file_from_body.matrix()).norm(), 1e-6);
  EXPECT_NEAR(one.facts.noise, other.facts.noise, 1e-7);
  EXPECT_EQ(one.facts.outliers, other.facts.outliers);
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_GT(one.mesh.normals[order[i]].dot(other.mesh.normals[i]), 0.99);
  }
}

TEST(MakeScan, IsTheSameEveryTime) {
  Mesh mesh = made_cloud({}, 20000, 0.0005);
  mesh.normals.clear();
  const Scan one = make_scan(mesh), other = make_scan(mesh);
  EXPECT_EQ(one.file_from_body.matrix(), other.file_from_body.matrix());
  EXPECT_EQ(one.mesh.positions, other.mesh.positions);
  EXPECT_EQ(one.mesh.normals, other.mesh.normals);
  EXPECT_EQ(one.outlier, other.outlier);
  EXPECT_EQ(one.facts.noise, other.facts.noise);
}

TEST(MakeScan, TakesGivenAxesExactly) {
  const Mesh turned = moved(made_person(), yaw(20));
  const Scan scan = make_scan(turned, {.units = "m", .up = "+y", .front = "+z"});
  EXPECT_LT((scan.file_from_body.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_FALSE(scan.facts.units_guessed || scan.facts.up_guessed || scan.facts.front_guessed);
  EXPECT_EQ(scan.facts.front_confidence, 1.0);
}

TEST(MakeScan, NamesTheNearestAxisButKeepsTheTrueFront) {
  const Scan scan = make_scan(moved(made_person(), yaw(20)));
  EXPECT_EQ(scan.facts.front, "+z");
  EXPECT_LT(degrees_between(front_in_file(scan), yaw(20) * Vec3::UnitZ()), 3.0);
}

TEST(MakeScan, KeepsAMirroredFileMirrored) {
  Mesh mirrored = made_person({.stride = 0.2});
  for (Vec3& p : mirrored.positions) p.x() = -p.x();
  for (Triangle& t : mirrored.triangles) std::swap(t[1], t[2]);
  EXPECT_GT(make_scan(mirrored).file_from_body.linear().determinant(), 0);
}

TEST(MakeScan, RefusesContradictoryOptions) {
  const Mesh person = made_person();
  EXPECT_THROW(make_scan(person, {.units = "feet"}), UsageError);
  EXPECT_THROW(make_scan(person, {.up = "y"}), UsageError);
  EXPECT_THROW(make_scan(person, {.up = "+y", .front = "-y"}), UsageError);
  EXPECT_THROW(make_scan(person, {.units = "mm"}), NoPersonError);
}

TEST(MakeScan, FindsUpAcrossAGivenFront) {
  const Scan scan = make_scan(made_person(), {.front = "+z"});
  EXPECT_EQ(scan.facts.up, "+y");
}

TEST(MakeScan, PutsABabysBodyInCentimetresAndAnAdultsInInches) {
  const Mesh adult = moved(made_person(), Eigen::Matrix3d::Identity(), 68 / 1.74);
  EXPECT_EQ(make_scan(adult).facts.units, "inch");
  const Mesh child = moved(made_person({.head = 1.8}), Eigen::Matrix3d::Identity(), 75 / 1.93);
  const Scan scan = make_scan(child);
  EXPECT_EQ(scan.facts.units, "cm");
  ASSERT_EQ(scan.facts.findings.size(), 1u);
  EXPECT_EQ(scan.facts.findings[0].code, "unsure_units");
  EXPECT_NEAR(scan.facts.height, 0.75, 0.01);
}

TEST(MakeScan, LeavesOutNumbersThatAreNone) {
  Mesh mesh = made_person();
  mesh.positions[10].x() = std::nan("");
  mesh.positions[20].z() = HUGE_VAL;
  const Scan scan = make_scan(mesh);
  EXPECT_EQ(scan.outlier[10] + scan.outlier[20], 2);
  EXPECT_EQ(scan.mesh.positions[10], Vec3(0, 0, 0));
  EXPECT_TRUE(scan.mesh.normals[20].allFinite());
  ASSERT_EQ(scan.facts.findings.size(), 1u);
  EXPECT_EQ(scan.facts.findings[0].code, "not_a_number");
}

TEST(MakeScan, SeesPastScatteredPoints) {
  Mesh mesh = cloud_of(made_cloud({}, 30000, 0.0005));
  mesh.normals.clear();
  const std::size_t real = mesh.positions.size();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  while (mesh.positions.size() < real + 300) {
    const Vec3 p(uniform(random), 1 + uniform(random), uniform(random));
    if (std::abs(p.z()) > 0.35) mesh.positions.push_back(p);  // 10 cm and more from the body
  }
  const Scan scan = make_scan(mesh);
  EXPECT_EQ(scan.facts.up, "+y");
  EXPECT_LT(degrees_between(front_in_file(scan), Vec3::UnitZ()), 3.0);
  EXPECT_NEAR(scan.facts.height, 1.74, 0.01);
  std::size_t found = 0, wrong = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    (v < real ? wrong : found) += scan.outlier[v];
  }
  EXPECT_GE(found, 297u);
  EXPECT_LE(wrong, real / 500);
  EXPECT_EQ(scan.facts.outliers, found + wrong);
}

// So many that each has others about as near as it is far from them.
TEST(MakeScan, SeesPastCrowdsOfScatteredPoints) {
  Mesh mesh = cloud_of(made_cloud({}, 60000, 0.0005));
  mesh.normals.clear();
  const std::size_t real = mesh.positions.size();
  const PointTree body(mesh.positions);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  while (mesh.positions.size() < real + 6000) {
    const Vec3 p(uniform(random), 1 + uniform(random), uniform(random));
    PointNeighbour nearest;
    body.nearest(p, {&nearest, 1});
    if (nearest.squared_distance > 0.03 * 0.03) mesh.positions.push_back(p);
  }
  const Scan scan = make_scan(mesh);
  std::size_t found = 0, wrong = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    (v < real ? wrong : found) += scan.outlier[v];
  }
  EXPECT_GE(found, 5100u);
  EXPECT_LE(wrong, real / 500);
}

}  // namespace
}  // namespace regarment
