#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bench/closest_point_rivals.h"

namespace regarment {
namespace {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area +=
        0.5 *
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm();
  return area;
}

TEST(Subdivide, KeepsTheSurface) {
  Mesh mesh = tetrahedron();
  subdivide(mesh, 1000);
  EXPECT_GE(mesh.triangles.size(), 1000U);
  EXPECT_NEAR(area_of(mesh), 1.5 + std::sqrt(3.0) / 2, 1e-9);
}

// Euler: a closed surface has V - E + F = 2, and each side is in two triangles.
TEST(Subdivide, LeavesAClosedSurfaceClosed) {
  for (const std::size_t least : {5U, 7U, 50U, 777U}) {
    Mesh mesh = tetrahedron();
    subdivide(mesh, least);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
    for (const auto& [side, times] : sides) {
      EXPECT_EQ(times, 1);
      EXPECT_TRUE(sides.contains({side.second, side.first}));
    }
    EXPECT_EQ(mesh.positions.size() - sides.size() / 2 + mesh.triangles.size(), 2U);
    EXPECT_LE(mesh.triangles.size(), least + 1);
  }
}

TEST(AskNear, AsksAtThatDistanceFromTheSurface) {
  const Mesh mesh = tetrahedron();
  const std::vector<Question> questions = ask_near(mesh, 0.01, 500);
  ASSERT_EQ(questions.size(), 500U);
  // In front of a face the nearest point of a convex body is where the question came from.
  const Finder cgal = cgal_finder(mesh);
  std::vector<double> found(questions.size());
  cgal.ask(questions, -1, found);
  for (std::size_t i = 0; i < found.size(); i += 2) EXPECT_NEAR(found[i], 0.01, 1e-12);
}

TEST(InOrder, AsksTheSameQuestions) {
  const std::vector<Question> questions = ask_near(tetrahedron(), 0.1, 200);
  const auto sorted = [](const std::vector<Question>& some) {
    std::multiset<double> out;
    for (const Question& q : some) out.insert(q.point.sum());
    return out;
  };
  EXPECT_EQ(sorted(in_order(questions)), sorted(questions));
}

}  // namespace
}  // namespace regarment
