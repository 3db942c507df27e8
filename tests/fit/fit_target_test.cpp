#include "fit/fit_target.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/dice.h"
#include "support/tubes.h"

namespace regarment {
namespace {

constexpr double kRadius = 0.2, kHeight = 1.2;  // m
constexpr int kSize = 128;                      // pixels

/// An upright cylinder, open at both ends.
Mesh cylinder(double middle_x = 0) {
  test::Tube tube;
  tube.origin = Vec3(middle_x, 0, 0);
  tube.stations = {{0, kRadius, kRadius}, {kHeight, kRadius, kRadius}};
  tube.closed = false;
  Mesh mesh;
  test::add_tube(tube, 0.01, {}, mesh);
  return mesh;
}

/// Points scattered evenly over the cylinder, each standing for a square of `spacing`.
Mesh scattered(double spacing, double middle_x = 0) {
  test::Dice dice(5);
  Mesh cloud;
  const double area = 2 * std::numbers::pi * kRadius * kHeight;
  const int count = static_cast<int>(area / (spacing * spacing));
  for (int i = 0; i < count; ++i) {
    const double turn = dice.uniform(0, 2 * std::numbers::pi);
    const Vec3 out(std::sin(turn), 0, std::cos(turn));
    cloud.positions.push_back(kRadius * out + Vec3(middle_x, dice.uniform(0, kHeight), 0));
    cloud.normals.push_back(out);
  }
  return cloud;
}

Mesh both(Mesh a, const Mesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return a;
}

/// What a silhouette covers, m^2.
double covered(const FitTarget& target, std::size_t side) {
  const double scale = target.cameras()[side].pixels_per_metre;
  return static_cast<double>(target.silhouettes()[side].area()) / (scale * scale);
}

TEST(FitTarget, TheSilhouettesOfACylinderAreRectangles) {
  const FitTarget target(cylinder(), {}, 0, kSize);
  ASSERT_EQ(target.silhouettes().size(), 4U);
  ASSERT_EQ(target.cameras().size(), 4U);
  for (std::size_t side = 0; side < 4; ++side) {
    const double pixel = 1 / target.cameras()[side].pixels_per_metre;
    // Each edge may be off by half a pixel; the sides of the polygon lie inside of the circle.
    const double bound = pixel * (2 * kRadius + kHeight) + pixel * pixel;
    EXPECT_NEAR(covered(target, side), 2 * kRadius * kHeight, bound) << side;
    EXPECT_EQ(target.silhouettes()[side].size, kSize);
  }
}

TEST(FitTarget, ThePersonDoesNotTouchThePicturesRim) {
  // A garment wider than the person must find room.
  const FitTarget target(cylinder(), {}, 0, kSize);
  for (const Silhouette& s : target.silhouettes())
    for (int i = 0; i < kSize; ++i)
      for (const int at : {i, i * kSize, (kSize - 1) * kSize + i, i * kSize + kSize - 1})
        ASSERT_EQ(s.covered[static_cast<std::size_t>(at)], 0);
}

TEST(FitTarget, ACloudHasTheSilhouettesOfItsSurface) {
  const double spacing = 0.012;
  const FitTarget cloud(scattered(spacing), {}, spacing, kSize);
  const double true_area = 2 * kRadius * kHeight;
  // A square reaches over each edge by at most its half side, which is `spacing`.
  const double widest = (2 * kRadius + 2 * spacing) * (kHeight + 2 * spacing);
  for (std::size_t side = 0; side < 4; ++side) {
    const double pixel = 1 / cloud.cameras()[side].pixels_per_metre;
    EXPECT_LT(covered(cloud, side), widest + 2 * pixel * (2 * kRadius + kHeight)) << side;
    // A place has at least 4 points of the near and 4 of the far side round it on average, and no
    // square over it with a probability of exp(-8): no holes worth a per cent.
    EXPECT_GT(covered(cloud, side), 0.99 * true_area) << side;
  }
}

TEST(FitTarget, LooksFromFrontLeftBackAndRight) {
  const FitTarget target(cylinder(), {}, 0, kSize);
  const std::vector<Vec3> expected = {Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitZ(), -Vec3::UnitX()};
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec3 towards_viewer = target.cameras()[side].view_from_body.row(2).transpose();
    EXPECT_NEAR((towards_viewer - expected[side]).norm(), 0, 1e-12) << side;
  }
}

void expect_same(const FitTarget& a, const FitTarget& b) {
  for (std::size_t side = 0; side < 4; ++side) {
    EXPECT_EQ(a.silhouettes()[side].covered, b.silhouettes()[side].covered) << side;
    EXPECT_EQ(a.cameras()[side].centre, b.cameras()[side].centre) << side;
  }
  for (const Vec3& p : {Vec3(0.9, 0.5, 0), Vec3(2, 0.6, 0.3), Vec3(-1, 0, 0)})
    EXPECT_EQ(a.surface().closest(p).point, b.surface().closest(p).point);
}

TEST(FitTarget, MaskedTrianglesAreNotThere) {
  const Mesh alone = cylinder(), pair = both(cylinder(), cylinder(1.5));
  std::vector<std::uint8_t> masked(pair.triangles.size(), 0);
  std::fill(masked.begin() + static_cast<std::ptrdiff_t>(alone.triangles.size()), masked.end(), 1);
  expect_same(FitTarget(pair, masked, 0, kSize), FitTarget(alone, {}, 0, kSize));
  EXPECT_GT(FitTarget(pair, {}, 0, kSize).surface().closest(Vec3(2, 0.6, 0)).point.x(), 1);
}

TEST(FitTarget, MaskedPointsAreNotThere) {
  const Mesh alone = scattered(0.02), pair = both(scattered(0.02), scattered(0.02, 1.5));
  std::vector<std::uint8_t> masked(pair.positions.size(), 0);
  std::fill(masked.begin() + static_cast<std::ptrdiff_t>(alone.positions.size()), masked.end(), 1);
  expect_same(FitTarget(pair, masked, 0.02, kSize), FitTarget(alone, {}, 0.02, kSize));
}

TEST(FitTarget, RefusesAScanOfWhichNothingIsLeft) {
  const Mesh mesh = cylinder(), cloud = scattered(0.05);
  const std::vector<std::uint8_t> triangles(mesh.triangles.size(), 1),
      points(cloud.positions.size(), 1);
  EXPECT_THROW(FitTarget(mesh, triangles, 0, kSize), InvalidInput);
  EXPECT_THROW(FitTarget(cloud, points, 0.05, kSize), InvalidInput);
  EXPECT_THROW(FitTarget(Mesh{}, {}, 0.05, kSize), InvalidInput);
  EXPECT_THROW(FitTarget(mesh, {}, 0, kSize, {1, 1}), InvalidInput);
}

}  // namespace
}  // namespace regarment
