#include "fill/border_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sheets.h"

namespace regarment {
namespace {

using test::sheet;

// Twice the area by the shoelace formula: positive when the loop turns counter-clockwise.
double turning(const Mesh& mesh, const std::vector<std::uint32_t>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 &a = mesh.positions[loop[i]], &b = mesh.positions[loop[(i + 1) % loop.size()]];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return sum;
}

TEST(BorderLoops, AreNoneOnAClosedSurface) {
  const std::vector<Triangle> tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_TRUE(border_loops(tetrahedron, 4).empty());
}

TEST(BorderLoops, HaveAHoleOnTheirLeft) {
  const Mesh mesh = sheet(6, 1.0, [](int i, int j) { return i == 2 && (j == 2 || j == 3); });
  const auto loops = border_loops(mesh.triangles, mesh.positions.size());
  ASSERT_EQ(loops.size(), 2u);
  std::vector<double> areas;
  for (const auto& loop : loops) areas.push_back(turning(mesh, loop) / 2);
  std::sort(areas.begin(), areas.end());
  EXPECT_DOUBLE_EQ(areas[0], -36);  // the sheet's rim: what is missing is outside
  EXPECT_DOUBLE_EQ(areas[1], 2);    // the two squares that are missing
}

// Two holes that touch in a vertex are two loops, so that each can be closed.
TEST(BorderLoops, AreTakenApartWhereHolesTouch) {
  const Mesh mesh =
      sheet(5, 1.0, [](int i, int j) { return (i == 1 && j == 1) || (i == 2 && j == 2); });
  std::size_t of_four = 0;
  for (const auto& loop : border_loops(mesh.triangles, mesh.positions.size())) {
    EXPECT_EQ(std::set<std::uint32_t>(loop.begin(), loop.end()).size(), loop.size());
    of_four += loop.size() == 4 ? 1 : 0;
  }
  EXPECT_EQ(of_four, 2u);
}

TEST(BorderLoops, LeaveOutWhatIsNoSurface) {
  // Three triangles on one edge, like the pages of a book.
  const std::vector<Triangle> book = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  EXPECT_TRUE(border_loops(book, 5).empty());
}

}  // namespace
}  // namespace regarment
