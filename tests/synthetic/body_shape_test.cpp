#include "synthetic/body_shape.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "base/error.h"
#include "synthetic/body_girths.h"
#include "synthetic/body_library.h"
#include "synthetic/body_rig.h"

namespace regarment {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Surface::Face_index;

// Pairs of triangles that pass through each other.
std::set<std::array<std::uint32_t, 2>> crossings(const Mesh& mesh) {
  Surface surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  using Index = Surface::Vertex_index;
  for (const Triangle& t : mesh.triangles) surface.add_face(Index(t[0]), Index(t[1]), Index(t[2]));
  std::vector<std::pair<Face, Face>> found;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(found));
  std::set<std::array<std::uint32_t, 2>> out;
  for (const auto& [a, b] : found)
    out.insert({std::min(a.idx(), b.idx()), std::max(a.idx(), b.idx())});
  return out;
}

Mesh library_body(std::size_t body) {
  Mesh mesh;
  mesh.positions = body_library().positions[body];
  mesh.triangles = body_library().triangles;
  return mesh;
}

BodyShape only(std::size_t body) {
  BodyShape shape;
  shape.blend = {};
  shape.blend[body] = 1;
  return shape;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
  }
  return sum;
}

// From the upper arm to the hand, seen from the front, outwards positive. Both ends are vertices
// that go with the arm alone.
Vec2 forearm(const Mesh& body, std::size_t side) {
  const std::vector<double>& weight = body_rig().arm[side];
  const std::vector<Vec3>& rest = body_library().positions[0];
  std::size_t low = 0, high = 0;
  for (std::size_t v = 0; v < weight.size(); ++v) {
    if (weight[v] < 1) continue;
    if (weight[low] < 1 || rest[v].y() < rest[low].y()) low = v;
    if (weight[high] < 1 || rest[v].y() > rest[high].y()) high = v;
  }
  const Vec3 line = body.positions[low] - body.positions[high];
  return {side == 0 ? line.x() : -line.x(), line.y()};
}

// Triangles that cross are those that cross in the library: lips and toes.
void expect_no_new_crossings(const BodyShape& shape, std::size_t body) {
  const auto old = crossings(library_body(body));
  for (const auto& pair : crossings(make_body(shape))) {
    EXPECT_TRUE(old.count(pair) > 0) << pair[0] << " " << pair[1];
  }
}

TEST(BodyShape, IsTheLibrarysBodyWhenNothingIsAsked) {
  BodyShape shape;
  const BodyJoints frame = body_joints(body_rig(), body_library().positions[0]);
  const Vec3& along = frame.arm_along[0];
  shape.arm_angle.fill(std::atan2(along.x(), -along.y()));
  const Mesh body = make_body(shape);
  for (std::size_t v = 0; v < body.positions.size(); ++v) {
    // The arms of the library are alike to half a step of its file.
    ASSERT_LT((body.positions[v] - body_library().positions[0][v]).norm(), 1e-4);
  }
}

TEST(BodyShape, MixesAndScales) {
  BodyShape shape = only(0);
  const Mesh one = make_body(shape), other = make_body(only(5));
  shape.blend[0] = 0.25, shape.blend[5] = 0.75;
  const Mesh mixed = make_body(shape);
  shape.scale = 1.1;
  const Mesh larger = make_body(shape);
  const double height = body_girths(mixed).height;
  // The lowest and the highest place are not the same on every body.
  EXPECT_NEAR(height, 0.25 * body_girths(one).height + 0.75 * body_girths(other).height, 3e-3);
  EXPECT_NEAR(body_girths(larger).height, 1.1 * height, 1e-9);
  EXPECT_NEAR(volume(larger), 1.331 * volume(mixed), 1e-9);
}

TEST(BodyShape, GrowsWhereItIsAsked) {
  const BodyGirths before = body_girths(make_body({}));
  BodyShape shape;
  shape.hips = 0.1;
  const BodyGirths wide = body_girths(make_body(shape));
  EXPECT_NEAR(wide.hip / before.hip, 1.1, 0.015);
  EXPECT_NEAR(wide.chest / before.chest, 1.0, 0.005);
  shape.hips = 0, shape.belly = 0.15;
  const BodyGirths belly = body_girths(make_body(shape));
  EXPECT_GT(belly.waist / before.waist, 1.05);
  EXPECT_NEAR(belly.chest / before.chest, 1.0, 0.03);
  EXPECT_GT(volume(make_body(shape)), volume(make_body({})));
}

TEST(BodyShape, HoldsTheArmsAtTheAngle) {
  BodyShape shape;
  shape.arm_angle = {0.25, 1.0};
  const Mesh body = make_body(shape), before = make_body({});
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec2 old = forearm(before, side), now = forearm(body, side);
    const double turn = std::atan2(now.x(), -now.y()) - std::atan2(old.x(), -old.y());
    EXPECT_NEAR(turn, shape.arm_angle[side] - 0.7, 1e-9);
  }
}

TEST(BodyShape, KeepsItsVolumeWhenItMoves) {
  BodyShape shape;
  const double before = volume(make_body(shape));
  shape.arm_angle = {0.3, 0.3}, shape.arms_back = 0.2, shape.legs = -0.08;
  shape.twist = 0.15, shape.lean = 0.06, shape.stoop = 0.1, shape.tilt = 0.05, shape.sway = 0.02;
  EXPECT_NEAR(volume(make_body(shape)) / before, 1.0, 0.02);
}

TEST(BodyShape, LeftAndRightAreMirrored) {
  BodyShape left, right;
  left.arm_angle = {0.4, 0.9}, left.lean = 0.05, left.tilt = 0.04, left.twist = 0.1;
  left.asymmetry = 0.3, left.hips = 0.1, left.sway = 0.02;
  right = left;
  std::swap(right.arm_angle[0], right.arm_angle[1]);
  right.lean = -left.lean, right.tilt = -left.tilt, right.twist = -left.twist;
  right.asymmetry = -left.asymmetry, right.sway = -left.sway;
  const Mesh one = make_body(left), other = make_body(right);
  Vec3 one_sum = Vec3::Zero(), other_sum = Vec3::Zero(), one_high = one_sum, other_low = one_sum;
  for (std::size_t v = 0; v < one.positions.size(); ++v) {
    one_sum += one.positions[v], other_sum += other.positions[v];
    one_high = one_high.cwiseMax(one.positions[v]);
    other_low = other_low.cwiseMin(other.positions[v]);
  }
  const auto n = static_cast<double>(one.positions.size());
  // The numbering of the two sides' triangles differs a little.
  EXPECT_NEAR(one_sum.x() / n, -other_sum.x() / n, 1e-4);
  EXPECT_NEAR(one_sum.z() / n, other_sum.z() / n, 1e-4);
  EXPECT_NEAR(one_high.x(), -other_low.x(), 1e-4);
}

TEST(BodyShape, NothingPassesThroughItself) {
  BodyShape shape = only(1);
  shape.belly = 0.2, shape.chest = 0.12, shape.hips = 0.15, shape.thighs = 0.12, shape.arms = 0.1;
  shape.legs = -0.08, shape.arm_angle = {0.15, 0.15}, shape.arms_back = 0.3;
  expect_no_new_crossings(with_free_arms(shape, 0.012), 1);
  shape = only(4);
  shape.arm_angle = {1.1, 0.3}, shape.twist = 0.2, shape.lean = 0.08, shape.stoop = 0.12;
  shape.tilt = 0.06, shape.sway = 0.03, shape.shoulders = 0.03, shape.hips = -0.1;
  expect_no_new_crossings(shape, 4);
}

TEST(BodyShape, FreesArmsThatTouch) {
  BodyShape shape = only(1);
  shape.arm_angle = {0.12, 0.9}, shape.arms_back = 0.35, shape.hips = 0.15;
  EXPECT_LT(arm_clearance(make_body(shape)), 0.01);
  const BodyShape free = with_free_arms(shape, 0.015);
  EXPECT_GE(arm_clearance(make_body(free)), 0.015);
  EXPECT_LT(free.arm_angle[0], 0.6);
  EXPECT_EQ(free.arm_angle[1], 0.9);
}

TEST(BodyShape, NamesTheFieldThatIsWrong) {
  BodyShape shape;
  shape.stoop = 0.5;
  try {
    make_body(shape);
    FAIL() << "somebody who lies on their nose was made";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("stoop"), std::string::npos) << e.what();
  }
  shape = {};
  shape.blend[3] = 0.5;
  EXPECT_THROW(make_body(shape), InvalidInput);
}

}  // namespace
}  // namespace regarment
