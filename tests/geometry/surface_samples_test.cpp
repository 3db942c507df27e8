#include "geometry/surface_samples.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/error.h"
#include "support/dice.h"
#include "support/tubes.h"

namespace regarment {
namespace {

using test::Dice;

Mesh random_triangles(std::size_t count, double size, std::uint64_t seed) {
  Dice dice(seed);
  Mesh mesh;
  for (std::uint32_t t = 0; t < count; ++t) {
    for (int k = 0; k < 3; ++k)
      mesh.positions.emplace_back(dice.uniform(0, size), dice.uniform(0, size),
                                  dice.uniform(0, size));
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  test::fill_normals(mesh);
  return mesh;
}

double area_of(const Mesh& mesh, const Triangle& t) {
  return 0.5 * (mesh.positions[t[1]] - mesh.positions[t[0]])
                   .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
                   .norm();
}

double sum(const std::vector<double>& v) {
  double total = 0;
  for (double x : v) total += x;
  return total;
}

TEST(SampleSurface, AreasSumToThatOfTheMesh) {
  const Mesh mesh = random_triangles(200, 0.1, 1);
  double expected = 0;
  for (const Triangle& t : mesh.triangles) expected += area_of(mesh, t);
  for (const double spacing : {0.003, 0.01, 0.05, 1.0}) {
    const SurfaceSamples samples = sample_surface(mesh, spacing);
    EXPECT_NEAR(sum(samples.areas), expected, 1e-12 * static_cast<double>(samples.size()))
        << spacing;
    EXPECT_EQ(samples.normals.size(), samples.size());
    EXPECT_EQ(samples.areas.size(), samples.size());
    EXPECT_EQ(samples.vertex.size(), samples.size());
    EXPECT_TRUE(samples.colours.empty());
  }
}

TEST(SampleSurface, AreasOfAClosedCylinderAreInClosedForm) {
  test::Tube tube;
  tube.stations = {{0, 0.15, 0.15}, {0.5, 0.15, 0.15}};
  Mesh mesh;
  test::add_tube(tube, 0.004, {}, mesh);
  test::fill_normals(mesh);
  const double expected = 2 * std::numbers::pi * 0.15 * (0.5 + 0.15);
  EXPECT_NEAR(sum(sample_surface(mesh, 0.006).areas), expected, 0.002 * expected);
}

TEST(SampleSurface, NoPointOfATriangleIsFurtherFromASampleThanTheSpacing) {
  Dice dice(2);
  for (int round = 0; round < 60; ++round) {
    const Mesh mesh = random_triangles(1, 0.1, 100 + round);
    const double spacing = dice.uniform(0.005, 0.03);
    const SurfaceSamples samples = sample_surface(mesh, spacing);
    for (int probe = 0; probe < 50; ++probe) {
      double a = dice.uniform(0, 1), b = dice.uniform(0, 1);
      if (a + b > 1) a = 1 - a, b = 1 - b;
      const Vec3 p =
          (1 - a - b) * mesh.positions[0] + a * mesh.positions[1] + b * mesh.positions[2];
      double nearest = 1e9;
      for (const Vec3& s : samples.positions) nearest = std::min(nearest, (s - p).norm());
      ASSERT_LE(nearest, spacing);
    }
  }
}

TEST(SampleSurface, SamplesLieOnTheirTriangleWithItsNormal) {
  for (int round = 0; round < 40; ++round) {
    const Mesh mesh = random_triangles(1, 0.1, 200 + round);
    const Vec3 &a = mesh.positions[0], &b = mesh.positions[1], &c = mesh.positions[2];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const SurfaceSamples samples = sample_surface(mesh, 0.01);
    ASSERT_GT(samples.size(), 0U);
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const Vec3& p = samples.positions[s];
      EXPECT_NEAR((p - a).dot(normal), 0, 1e-12);
      // Inside: on the inner side of all three edges.
      EXPECT_GT((b - a).cross(p - a).dot(normal), 0);
      EXPECT_GT((c - b).cross(p - b).dot(normal), 0);
      EXPECT_GT((a - c).cross(p - c).dot(normal), 0);
      EXPECT_LT((samples.normals[s] - normal).norm(), 1e-12);
      EXPECT_LT(samples.vertex[s], 3U);
    }
  }
}

TEST(SampleSurface, OfAnEquilateralTriangleEachSampleCameFromTheNearestCorner) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1, 0, 0}, {0.05, 0.1 * std::sqrt(0.75), 0}};
  mesh.triangles = {{0, 1, 2}};
  test::fill_normals(mesh);
  const SurfaceSamples samples = sample_surface(mesh, 0.007);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    double nearest = 1e9;
    for (const Vec3& corner : mesh.positions)
      nearest = std::min(nearest, (samples.positions[s] - corner).norm());
    EXPECT_NEAR((samples.positions[s] - mesh.positions[samples.vertex[s]]).norm(), nearest, 1e-12);
  }
}

TEST(SampleSurface, ColoursRunEvenlyAcrossATriangle) {
  Mesh mesh = random_triangles(1, 0.1, 5);
  mesh.colours = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
  const SurfaceSamples samples = sample_surface(mesh, 0.01);
  ASSERT_EQ(samples.colours.size(), samples.size());
  for (std::size_t s = 0; s < samples.size(); ++s) {
    // The colours are the weights of the corners.
    const Vec3& w = samples.colours[s];
    EXPECT_NEAR(w.sum(), 1, 1e-12);
    EXPECT_LT((w[0] * mesh.positions[0] + w[1] * mesh.positions[1] + w[2] * mesh.positions[2] -
               samples.positions[s])
                  .norm(),
              1e-12);
  }
}

TEST(SampleSurface, TakesTheVerticesOfACloudAsTheyAre) {
  Mesh cloud = random_triangles(50, 1, 6);
  cloud.triangles.clear();
  std::vector<std::uint8_t> skip(cloud.positions.size(), 0);
  skip[3] = skip[100] = 1;
  const SurfaceSamples samples = sample_surface(cloud, 0.005, skip);
  ASSERT_EQ(samples.size(), cloud.positions.size() - 2);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    EXPECT_EQ(samples.positions[s], cloud.positions[samples.vertex[s]]);
    EXPECT_EQ(samples.normals[s], cloud.normals[samples.vertex[s]]);
    EXPECT_DOUBLE_EQ(samples.areas[s], 0.005 * 0.005);
    EXPECT_TRUE(samples.vertex[s] != 3 && samples.vertex[s] != 100);
  }
}

TEST(SampleSurface, LeavesOutTrianglesThatTouchSkippedVertices) {
  const Mesh mesh = random_triangles(20, 0.1, 7);
  std::vector<std::uint8_t> skip(mesh.positions.size(), 0);
  skip[3 * 4 + 1] = skip[3 * 9] = 1;
  double expected = 0;
  for (std::size_t t = 0; t < 20; ++t)
    if (t != 4 && t != 9) expected += area_of(mesh, mesh.triangles[t]);
  const SurfaceSamples samples = sample_surface(mesh, 0.01, skip);
  EXPECT_NEAR(sum(samples.areas), expected, 1e-12);
  for (std::uint32_t v : samples.vertex) EXPECT_TRUE(v / 3 != 4 && v / 3 != 9);
}

TEST(SampleSurface, TrianglesWithoutAreaGiveNothing) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}};
  mesh.normals.assign(3, Vec3::UnitY());
  EXPECT_EQ(sample_surface(mesh, 0.01).size(), 0U);
}

TEST(SampleSurface, NeedsNormals) {
  Mesh mesh = random_triangles(1, 0.1, 8);
  mesh.normals.clear();
  EXPECT_THROW(sample_surface(mesh, 0.01), InvalidInput);
}

}  // namespace
}  // namespace regarment
