#include "scan/mesh_edges.h"

#include <gtest/gtest.h>

#include "scan/weld.h"

namespace regarment {
namespace {

const std::vector<Triangle> kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// A tube of `n` squares, open at both ends: ring 0..n-1 below, n..2n-1 above.
std::vector<Triangle> tube(std::uint32_t n) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    triangles.push_back({i, j, n + i});
    triangles.push_back({j, n + j, n + i});
  }
  return triangles;
}

TEST(MeshEdges, OfAClosedMeshAreAllPairs) {
  const MeshEdges edges = find_edges(kTetrahedron, 4);
  EXPECT_EQ(edges.pairs.size(), 6u);
  EXPECT_TRUE(edges.border.empty());
  for (const auto& pair : edges.pairs) EXPECT_TRUE(pair.same_winding);
}

TEST(MeshEdges, CountHoles) {
  EXPECT_EQ(count_holes(find_edges(kTetrahedron, 4), 4), 0u);
  const std::vector<Triangle> open(kTetrahedron.begin() + 1, kTetrahedron.end());
  EXPECT_EQ(count_holes(find_edges(open, 4), 4), 1u);
  EXPECT_EQ(count_holes(find_edges(tube(7), 14), 14), 2u);
}

TEST(MeshEdges, OfThreeTrianglesAreNeitherPairNorBorder) {
  const std::vector<Triangle> fan = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const MeshEdges edges = find_edges(fan, 5);
  EXPECT_TRUE(edges.pairs.empty());
  EXPECT_EQ(edges.border.size(), 6u);
}

TEST(Sheets, AreCountedAndWoundAlike) {
  std::vector<Triangle> two = tube(6);
  for (const auto& [a, b, c] : kTetrahedron) two.push_back({12 + a, 12 + b, 12 + c});
  std::swap(two[3][0], two[3][1]);
  std::swap(two[13][0], two[13][1]);
  const Sheets sheets = find_sheets(two.size(), find_edges(two, 16));
  EXPECT_EQ(sheets.count, 2u);
  for (std::size_t t = 0; t < two.size(); ++t) {
    EXPECT_EQ(sheets.of_triangle[t], t < 12 ? 0u : 1u);
    EXPECT_EQ(sheets.turn[t], t == 3 || t == 13 ? 1 : 0);
  }
}

TEST(Weld, JoinsEqualPositionsAndDropsWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> vertices = {
      {0, 1, 2}, {-0.0, 1, 2}, {nan, 0, 0}, {0, 1, 2.0000001}, {0, 1, 2}};
  const Welded welded = weld(vertices);
  EXPECT_EQ(welded.positions.size(), 2u);
  EXPECT_EQ(welded.of_vertex, (std::vector<std::uint32_t>{0, 0, Welded::kNone, 1, 0}));
  const std::vector<Triangle> triangles = {{0, 1, 3}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_TRUE(weld_triangles(triangles, welded).empty());
}

}  // namespace
}  // namespace regarment
