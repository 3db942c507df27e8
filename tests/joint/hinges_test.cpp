#include "joint/hinges.h"

#include <gtest/gtest.h>

#include "rolled_skirt.h"

namespace regarment {
namespace {

Vec3 curvature_of(const Hinge& hinge, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int c = 0; c < 4; ++c) sum += hinge.weights[c] * x[hinge.particles[c]];
  return sum;
}

TEST(Hinges, DoNotSeeMovesAndTurns) {
  const Pattern pattern = make_pattern(find_template("skirt"), tube_dimensions(1.0, 0.5), 0.05);
  const std::vector<Vec3> x = particles_of(pattern, rolled(pattern, 1.0, 0.16));
  std::vector<Vec3> moved;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).matrix();
  for (const Vec3& p : x) moved.push_back(turn * p + Vec3(3, -2, 5));
  for (const Hinge& hinge : hinges(pattern))
    EXPECT_NEAR(curvature_of(hinge, x).norm(), curvature_of(hinge, moved).norm(), 1e-7);
}

// The centre front runs along the cylinder's axis; both triangles at it turn by half their height
// over the radius, which is spread over a third of both heights.
TEST(Hinges, MeasureTheCurvatureOfACylinder) {
  const GarmentTemplate skirt = find_template("skirt");
  for (const double girth : {0.8, 1.6}) {
    const Pattern pattern = make_pattern(skirt, tube_dimensions(girth, 0.5), 0.02);
    const double radius = girth / (2 * std::numbers::pi);
    const std::vector<Vec3> x = particles_of(pattern, rolled(pattern, girth, radius));
    int along = 0;
    for (const Hinge& hinge : hinges(pattern)) {
      const Vec3 &a = x[hinge.particles[2]], &b = x[hinge.particles[3]];
      if (std::hypot(a.x() - b.x(), a.z() - b.z()) > 1e-9) continue;
      EXPECT_NEAR(curvature_of(hinge, x).norm() * radius, 1.5, 0.01);
      ++along;
    }
    EXPECT_GT(along, 20);
  }
}

TEST(Hinges, EveryInnerSideOnce) {
  const Pattern pattern =
      make_pattern(find_template("tshirt"), find_template("tshirt").typical(), 0.05);
  const std::size_t sides = 3 * pattern.triangles.size();
  std::size_t open = 0;
  for (const PatternEdge& edge : pattern.edges) open += edge.vertices.size();
  EXPECT_EQ(2 * hinges(pattern).size() + open, sides);
}

}  // namespace
}  // namespace regarment
