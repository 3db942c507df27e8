#include "synthetic/body_girths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synthetic/body_shape.h"
#include "synthetic/slice_loops.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;

// Adds an upright elliptic tube from the floor to `height`, closed above and below.
void add_tube(Mesh& mesh, Vec2 centre, double a, double b, double height, int sides = 720) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / sides;
    const double x = centre.x() + a * std::cos(angle), z = centre.y() - b * std::sin(angle);
    mesh.positions.emplace_back(x, 0, z);
    mesh.positions.emplace_back(x, height, z);
  }
  mesh.positions.emplace_back(centre.x(), 0, centre.y());
  mesh.positions.emplace_back(centre.x(), height, centre.y());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t low = first + 2 * i, next = first + 2 * ((i + 1) % n);
    mesh.triangles.push_back({low, next, next + 1});
    mesh.triangles.push_back({low, next + 1, low + 1});
    mesh.triangles.push_back({first + 2 * n, next, low});
    mesh.triangles.push_back({first + 2 * n + 1, low + 1, next + 1});
  }
}

TEST(TapeGirth, IsTheCircumferenceOfACylinder) {
  Mesh mesh;
  add_tube(mesh, {0.02, -0.01}, 0.15, 0.15, 1.8);
  // A polygon of 720 sides is shorter than its circle by 3e-6 of it.
  EXPECT_NEAR(tape_girth(mesh, 0.9), 2 * kPi * 0.15, 1e-5);
  EXPECT_EQ(tape_girth(mesh, 2.0), 0);
}

TEST(TapeGirth, IsThePerimeterOfAnEllipse) {
  Mesh mesh;
  const double a = 0.18, b = 0.11;
  add_tube(mesh, {0, 0}, a, b, 1.8);
  const double h = std::pow((a - b) / (a + b), 2);  // Ramanujan's second formula
  EXPECT_NEAR(tape_girth(mesh, 1.0), kPi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h))),
              1e-5);
}

TEST(TapeGirth, LeavesOutTheArms) {
  Mesh mesh;
  add_tube(mesh, {0, 0}, 0.15, 0.15, 1.8);
  add_tube(mesh, {0.3, 0.05}, 0.04, 0.04, 1.8);
  add_tube(mesh, {-0.3, 0.05}, 0.04, 0.04, 1.8);
  EXPECT_NEAR(tape_girth(mesh, 1.0), 2 * kPi * 0.15, 1e-5);
}

TEST(TapeGirth, GoesRoundBothLegs) {
  Mesh mesh;
  add_tube(mesh, {0.1, 0}, 0.08, 0.08, 0.8);
  add_tube(mesh, {-0.1, 0}, 0.08, 0.08, 0.8);
  EXPECT_NEAR(tape_girth(mesh, 0.4), 2 * kPi * 0.08 + 2 * 0.2, 1e-5);
}

TEST(HullPerimeter, SpansHollows) {
  EXPECT_DOUBLE_EQ(hull_perimeter({{0, 0}, {1, 0}, {0.5, 0.1}, {1, 1}, {0, 1}, {0.2, 0.5}}), 4);
  EXPECT_DOUBLE_EQ(hull_perimeter({{0, 0}, {3, 4}}), 10);
  EXPECT_EQ(hull_perimeter({{1, 2}}), 0);
  EXPECT_EQ(hull_perimeter({}), 0);
}

TEST(SliceLoops, KnowTheirAreaAndCentre) {
  Mesh mesh;
  add_tube(mesh, {0.3, -0.2}, 0.15, 0.1, 1.0);
  const std::vector<Loop> loops = slice_loops(mesh, 0.5);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_NEAR(loops[0].area, kPi * 0.15 * 0.1, 1e-5);
  EXPECT_TRUE(loops[0].centre.isApprox(Vec2(0.3, -0.2), 1e-9));
}

TEST(SliceLoops, LeaveOutWhatIsOpen) {
  Mesh mesh;
  add_tube(mesh, {0, 0}, 0.15, 0.15, 1.0);
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
  EXPECT_TRUE(slice_loops(mesh, 0.5).empty());
}

TEST(BodyGirths, AreThoseOfAPerson) {
  const BodyGirths girths = body_girths(make_body({}));
  EXPECT_LT(girths.crotch, girths.hip_height);
  EXPECT_LT(girths.hip_height, girths.waist_height);
  EXPECT_LT(girths.waist_height, girths.chest_height);
  EXPECT_LT(girths.waist, girths.hip);
  EXPECT_LT(girths.waist, girths.chest);
  EXPECT_LT(girths.wrist_girth, girths.upper_arm_girth);
  EXPECT_NEAR(girths.height, 1.67, 0.01);  // as the file of this body says
}

}  // namespace
}  // namespace regarment
