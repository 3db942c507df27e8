#include "synthetic/yield.h"

#include <gtest/gtest.h>

#include "made_sheets.h"
#include "synthetic/penetration.h"

namespace regarment {
namespace {

/// A block with a fine flat top at y = 0, 0.4 m wide, vertex i + 41 j of the top at (i, j) cm.
Mesh block() {
  const Pattern grid = grid_pattern(40, 40, 0.01);
  Mesh mesh;
  for (const Vec2& p : grid.flat) mesh.positions.emplace_back(p.x(), 0, p.y());
  for (const Triangle& t : grid.triangles) mesh.triangles.push_back(t);
  // Counter-clockwise seen from above; closed by a lid far below.
  const auto top = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t v = 0; v < top; ++v)
    mesh.positions.emplace_back(mesh.positions[v] - Vec3(0, 0.3, 0));
  for (const Triangle& t : grid.triangles)
    mesh.triangles.push_back({t[0] + top, t[2] + top, t[1] + top});
  return mesh;
}

/// Cloth that covers the middle of the block, 1 mm thick, at height `y`.
WornGarment cover(double y) {
  WornGarment out;
  out.pattern = grid_pattern(20, 20, 0.01);
  out.fabric.thickness = 0.001;
  out.particles =
      placed(out.pattern, [&](const Vec2& p) { return Vec3(0.1 + p.x(), y, 0.1 + p.y()); });
  return out;
}

std::size_t at(int i, int j) { return static_cast<std::size_t>(i + 41 * j); }

TEST(YieldToCloth, PressesInWhatSticksThroughIt) {
  DressedPerson person{block(), {cover(0.003)}};
  person.body.positions[at(20, 20)].y() = 0.008;  // through the cloth
  person.body.positions[at(5, 5)].y() = 0.008;    // beside it
  person.body.positions[at(15, 15)].y() = 0.001;  // below it
  yield_to_cloth(person);
  EXPECT_LT(person.body.positions[at(20, 20)].y(), 0.003 - 0.0005);
  EXPECT_GT(person.body.positions[at(20, 20)].y(), 0.0);
  EXPECT_EQ(person.body.positions[at(5, 5)].y(), 0.008);
  EXPECT_EQ(person.body.positions[at(15, 15)].y(), 0.001);
}

TEST(YieldToCloth, PressesALowerGarmentUnderTheUpperOne) {
  DressedPerson person{block(), {cover(0.004), cover(0.002)}};
  const auto middle = static_cast<std::size_t>(10 + 21 * 10);
  person.garments[1].particles[middle].y() = 0.007;
  yield_to_cloth(person);
  EXPECT_LE(person.garments[1].particles[middle].y(), 0.004 - 0.001 + 1e-12);
  EXPECT_EQ(person.garments[0].particles[middle].y(), 0.004);
}

TEST(DeepestInside, IsTheDepthOfTheDeepestSample) {
  const Mesh body = block();
  const std::vector<Triangle> triangle = {{0, 1, 2}};
  const auto at_height = [](double y) {
    return std::vector<Vec3>{{0.2, y, 0.2}, {0.21, y, 0.2}, {0.2, y, 0.21}};
  };
  EXPECT_NEAR(deepest_inside(body, triangle, at_height(-0.004)), 0.004, 1e-12);
  EXPECT_EQ(deepest_inside(body, triangle, at_height(0.002)), 0.0);
  std::vector<Vec3> dipping = at_height(0.001);
  dipping[2].y() = -0.007;
  EXPECT_NEAR(deepest_inside(body, triangle, dipping), 0.007, 1e-12);
}

}  // namespace
}  // namespace regarment
