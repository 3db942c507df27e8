#include "synthetic/falling_sheet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "made_sheets.h"

namespace regarment {
namespace {

constexpr double kGravity = 9.81;

std::vector<Vec3> level(const Pattern& pattern, double y) {
  return placed(pattern, [&](const Vec2& p) { return Vec3(p.x(), y, p.y()); });
}

Vec3 middle(const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : x) sum += p;
  return sum / static_cast<double>(x.size());
}

TEST(FallingSheet, FallsAsEverythingDoesInAVacuum) {
  const Pattern pattern = grid_pattern(5, 5, 0.02);
  const Sheet sheet = make_sheet(pattern, {});
  FallingSheet moving(sheet, level(pattern, 0));
  FallOptions options;
  options.air = 0;
  options.fastest = 100;
  const int steps = 400;
  for (int i = 0; i < steps; ++i) moving.step({}, options);
  const double t = steps * options.time_step;
  // Steps of constant speed fall by g dt t / 2 more.
  EXPECT_NEAR(middle(moving.positions()).y(), -0.5 * kGravity * t * (t + options.time_step), 1e-6);
}

/// How far a small sheet slides down a slope of `angle` in half a second.
double slide_on(double angle, double friction) {
  const Pattern pattern = grid_pattern(4, 4, 0.02);
  SheetFabric fabric;
  fabric.friction = friction;
  const Sheet sheet = make_sheet(pattern, fabric);
  const Vec3 normal(std::sin(angle), std::cos(angle), 0),
      down(std::cos(angle), -std::sin(angle), 0);
  const MadePlane plane(Vec3::Zero(), normal);
  const Obstacle slope(ObstacleKind::Body, plane.triangles, plane.corners, 0.0);
  FallingSheet moving(sheet, placed(pattern, [&](const Vec2& p) {
                        return Vec3(p.x() * down + Vec3(0, 0, p.y()) + 0.002 * normal);
                      }));
  const Vec3 start = middle(moving.positions());
  FallOptions options;
  options.air = 0;
  for (int i = 0; i < 500; ++i) moving.step({&slope}, options);
  return (middle(moving.positions()) - start).dot(down);
}

// Coulomb: it sticks while the slope's tangent is below the friction, and beyond that it slides
// with g (sin a - mu cos a).
TEST(FallingSheet, SticksOnASlopeFlatterThanItsFriction) {
  EXPECT_LT(std::abs(slide_on(0.3, 0.4)), 0.001);
}

TEST(FallingSheet, SlidesOnASteeperSlopeAsCoulombSays) {
  const double angle = 0.5, friction = 0.3, t = 0.5;
  const double expected = 0.5 * kGravity * (std::sin(angle) - friction * std::cos(angle)) * t * t;
  EXPECT_NEAR(slide_on(angle, friction), expected, 0.03 * expected);
}

TEST(FallingSheet, LiesOnASphereAndNotInIt) {
  // An octahedron split four times.
  std::vector<Vec3> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> triangles = {{4, 0, 2}, {4, 2, 1}, {4, 1, 3}, {4, 3, 0},
                                     {5, 2, 0}, {5, 1, 2}, {5, 3, 1}, {5, 0, 3}};
  for (int round = 0; round < 4; ++round) {
    std::vector<Triangle> finer;
    for (const Triangle& t : triangles) {
      Triangle mid;
      for (std::size_t k = 0; k < 3; ++k) {
        mid[k] = static_cast<std::uint32_t>(points.size());
        points.push_back((points[t[k]] + points[t[(k + 1) % 3]]).normalized());
      }
      finer.insert(finer.end(), {{t[0], mid[0], mid[2]},
                                 {mid[0], t[1], mid[1]},
                                 {mid[2], mid[1], t[2]},
                                 {mid[0], mid[1], mid[2]}});
    }
    triangles = finer;
  }
  const double radius = 0.12;
  for (Vec3& p : points) p *= radius;
  const Obstacle ball(ObstacleKind::Body, triangles, points, 0.0);
  const int cells = 20;
  const double h = 0.02;
  const Pattern pattern = grid_pattern(cells, cells, h);
  SheetFabric fabric;
  fabric.friction = 0.5;
  const Sheet sheet = make_sheet(pattern, fabric);
  FallingSheet moving(sheet, placed(pattern, [&](const Vec2& p) {
                        return Vec3(p.x() - cells * h / 2, radius + 0.01, p.y() - cells * h / 2);
                      }));
  FallOptions options;
  options.air = 4;
  for (int i = 0; i < 2500; ++i) moving.step({&ball}, options);
  double nearest = 1e9, lowest = 1e9;
  for (const Vec3& p : moving.positions()) {
    nearest = std::min(nearest, p.norm());
    lowest = std::min(lowest, p.y());
  }
  EXPECT_GE(nearest, radius);
  const Vec3& top =
      moving.positions()[static_cast<std::size_t>((cells + 1) * (cells / 2) + cells / 2)];
  // Half the thickness and the air below the cloth.
  EXPECT_NEAR(top.norm(), radius + fabric.thickness / 2 + 0.001, 0.001);
  EXPECT_LT(lowest, 0.0);  // the corners hang down beside it
  EXPECT_LT(moving.speed(0.99), 0.05);
}

// Two sheets in one, one falling on the other, which lies on the floor.
TEST(FallingSheet, FoldsDoNotPassThroughEachOther) {
  Pattern pattern = grid_pattern(6, 6, 0.02);
  const Pattern one = pattern;
  const auto n = static_cast<std::uint32_t>(one.flat.size());
  for (std::size_t v = 0; v < n; ++v) {
    pattern.flat.emplace_back(one.flat[v].x() + 1, one.flat[v].y());
    pattern.panel.push_back(0);
    pattern.particle.push_back(static_cast<int>(v + n));
  }
  for (const Triangle& t : one.triangles)
    pattern.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  pattern.particle_count = static_cast<int>(2 * n);
  SheetFabric fabric;
  fabric.thickness = 0.005;
  const Sheet sheet = make_sheet(pattern, fabric);
  const MadePlane plane(Vec3::Zero(), Vec3::UnitY());
  const Obstacle floor(ObstacleKind::Body, plane.triangles, plane.corners, 0.0);
  FallingSheet moving(sheet, placed(pattern, [&](const Vec2& p) {
                        const bool upper = p.x() > 0.5;
                        return Vec3(upper ? p.x() - 1 + 0.007 : p.x(), upper ? 0.03 : 0.005,
                                    p.y() + (upper ? 0.005 : 0));
                      }));
  FallOptions options;
  options.air = 5;
  for (int i = 0; i < 1000; ++i) moving.step({&floor}, options);
  double low = 1e9;
  for (std::size_t p = n; p < 2 * n; ++p) low = std::min(low, moving.positions()[p].y());
  // Over the lower sheet, whose middle is half a thickness and the air above the floor.
  EXPECT_GT(low, fabric.thickness / 2 + 0.8 * fabric.thickness);
  EXPECT_LT(low, 2.5 * fabric.thickness);
}

TEST(FallingSheet, KeepsWhatIsHeldAtItsHeight) {
  const Pattern pattern = grid_pattern(3, 6, 0.02);
  const Sheet sheet = make_sheet(pattern, {});
  FallingSheet moving(sheet, placed(pattern, [](const Vec2& p) { return Vec3(p.x(), -p.y(), 0); }));
  moving.hold_level({0, 1, 2, 3});
  for (int i = 0; i < 500; ++i) moving.step({}, {});
  for (std::size_t p = 0; p < 4; ++p) EXPECT_EQ(moving.positions()[p].y(), 0.0);
  EXPECT_NEAR(moving.positions().back().y(), -0.12, 0.02);
}

}  // namespace
}  // namespace regarment
