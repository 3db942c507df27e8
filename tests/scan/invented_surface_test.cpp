#include "scan/invented_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scan/cone_person.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

/// A flat square grid: its first corner, the length of its sides and of its cells, m.
Mesh grid(const Vec3& corner, double side, double cell) {
  const auto steps = static_cast<std::uint32_t>(std::lround(side / cell));
  Mesh mesh;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    for (std::uint32_t j = 0; j <= steps; ++j) {
      mesh.positions.push_back(corner + Vec3(i * cell, 0, j * cell));
    }
  }
  for (std::uint32_t i = 0; i < steps; ++i) {
    for (std::uint32_t j = 0; j < steps; ++j) {
      const std::uint32_t a = i * (steps + 1) + j, b = a + steps + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({b, a + 1, b + 1});
    }
  }
  return mesh;
}

TEST(InventedSurface, IsWhereAnEvenMeshTurnsCoarse) {
  Mesh mesh = grid(Vec3::Zero(), 2.0, 0.02);
  const std::size_t fine = mesh.positions.size();
  test::append(mesh, grid(Vec3(3, 0, 0), 0.4, 0.04));
  const auto invented = find_invented(mesh.positions, mesh.triangles);
  for (std::size_t v = 0; v < invented.size(); ++v) EXPECT_EQ(invented[v], v >= fine ? 1 : 0);
}

TEST(InventedSurface, IsNowhereInAMeshThatIsEvenOrUnevenAllOver) {
  Mesh even = grid(Vec3::Zero(), 2.0, 0.02), uneven = even;
  // A second part of half as many vertices in large triangles: that is how the figure was made.
  test::append(uneven, grid(Vec3(3, 0, 0), 3.0, 0.04));
  for (const Mesh& mesh : {even, uneven}) {
    const auto invented = find_invented(mesh.positions, mesh.triangles);
    EXPECT_EQ(std::count(invented.begin(), invented.end(), 1), 0);
  }
}

TEST(InventedSurface, OfACloudIsNotSpokenOf) {
  Mesh cloud = test::cloud_of(test::made_cloud({}, 20000));
  cloud.normals.clear();
  EXPECT_TRUE(make_scan(cloud).invented.empty());
  EXPECT_TRUE(find_invented({}, {}).empty());
}

}  // namespace
}  // namespace regarment
