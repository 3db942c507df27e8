#include "geometry/closest_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.h"
#include "support/dice.h"

namespace regarment {
namespace {

using test::Dice;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Squares of side 1 in z = 0, facing up, each cut from its lower left to its upper right corner:
/// the lower right half first, then the upper left one. Vertex (x, y) is x + (columns + 1) y.
Mesh flat_patch(std::uint32_t columns, std::uint32_t rows) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= rows; ++y)
    for (std::uint32_t x = 0; x <= columns; ++x) mesh.positions.emplace_back(x, y, 0);
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = x + (columns + 1) * y, b = a + 1, d = a + columns + 1, c = d + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

ClosestPoint tree_of(const Mesh& mesh, const std::vector<std::uint8_t>& masked = {}) {
  return {std::span(mesh.positions), std::span(mesh.triangles), masked};
}

ClosestPoint tree_of_points(const std::vector<Vec3>& points,
                            const std::vector<Vec3>& normals = {}) {
  return {std::span(points), std::span(normals)};
}

/// Points spread evenly over the unit sphere along a spiral; none is farther than `spacing` from
/// its neighbours.
std::vector<Vec3> sphere_points(int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double y = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - y * y);
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    points.push_back(Vec3(r * std::cos(angle), y, r * std::sin(angle)).normalized());
  }
  return points;
}

TEST(ClosestPoint, SaysWhereItIsAndWhichWayItFaces) {
  const ClosestHit hit = tree_of(flat_patch(2, 2)).closest({0.75, 0.25, -3});
  EXPECT_EQ(hit.element, 0u);
  EXPECT_EQ(hit.point, Vec3(0.75, 0.25, 0));
  EXPECT_EQ(hit.normal, Vec3(0, 0, 1));
  EXPECT_EQ(hit.squared_distance, 9);
}

TEST(ClosestPoint, OfACloudHasTheNormalAsGiven) {
  const ClosestPoint tree = tree_of_points({{0, 0, 0}, {1, 0, 0}}, {Vec3::UnitZ(), Vec3::Zero()});
  EXPECT_EQ(tree.closest({0.2, 0, 0}).normal, Vec3::UnitZ());
  EXPECT_EQ(tree.closest({0.9, 0, 0}).normal, Vec3::Zero());
}

TEST(ClosestPoint, FindsNothingInNothing) {
  const ClosestPoint none = tree_of({});
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.closest({1, 2, 3}).found());
  EXPECT_TRUE(tree_of(flat_patch(1, 1), {1, 1}).empty());
  EXPECT_TRUE(tree_of_points({}).empty());
  EXPECT_FALSE(tree_of(flat_patch(1, 1)).empty());
}

TEST(ClosestPoint, ReachesJustTheLargestDistance) {
  const ClosestPoint tree = tree_of(flat_patch(1, 1));
  EXPECT_TRUE(tree.closest({0.5, 0.25, 0.75}, {.max_distance = 0.75}).found());
  EXPECT_FALSE(tree.closest({0.5, 0.25, 0.75}, {.max_distance = std::nextafter(0.75, 0)}).found());
  EXPECT_TRUE(tree.closest({0.5, 0.25, 0}, {.max_distance = 0}).found());
  EXPECT_FALSE(tree.closest({0.5, 0.25, 0}, {.max_distance = -1}).found());
}

TEST(ClosestPoint, IsTheLowestIndexOfThoseAtACommonCorner) {
  // Above the apex of a pyramid all its sides are equally near, however they are listed.
  Mesh mesh;
  mesh.positions = {{0.1, 0.2, 0.7}};
  for (int i = 0; i < 11; ++i)
    mesh.positions.emplace_back(std::cos(0.57 * i), std::sin(0.57 * i), -0.3);
  for (std::uint32_t i = 1; i <= 11; ++i) mesh.triangles.push_back({0, i, i % 11 + 1});
  Dice dice(4);
  for (int round = 0; round < 20; ++round) {
    dice.shuffle(mesh.triangles);
    for (Triangle& t : mesh.triangles) std::rotate(t.begin(), t.begin() + dice.below(3), t.end());
    const ClosestHit hit = tree_of(mesh).closest({0.11, 0.19, 1.3});
    EXPECT_EQ(hit.element, 0u);
    EXPECT_EQ(hit.point, mesh.positions[0]);
  }
}

TEST(ClosestPoint, IsTheLowestIndexOfTwoAtACommonEdge) {
  // A ridge whose edge has coordinates that no float or sum is exact for.
  const std::vector<Vec3> positions{{0.1, 0.7, 0.3}, {0.9, 0.2, 0.4}, {0.3, -1, -1}, {0.8, 2, -1}};
  const std::vector<Triangle> one_way{{0, 1, 2}, {1, 0, 3}}, other_way{{3, 1, 0}, {2, 0, 1}};
  for (const auto& triangles : {one_way, other_way}) {
    const ClosestPoint tree{std::span(positions), std::span(triangles)};
    for (const double t : {0.05, 0.15, 0.35, 0.55, 0.7, 0.85, 0.95}) {
      const Vec3 query = positions[0] + t * (positions[1] - positions[0]) + Vec3(0, 0, 0.5);
      EXPECT_EQ(tree.closest(query).element, 0u) << t;
    }
  }
}

TEST(ClosestPoint, IsTheLowestIndexOfTheSameTrianglesAndPoints) {
  Mesh mesh = flat_patch(1, 1);
  mesh.triangles.assign(40, {0, 1, 2});
  for (std::size_t t = 1; t < 40; t += 2) mesh.triangles[t] = {2, 0, 1};
  EXPECT_EQ(tree_of(mesh).closest({0.6, 0.2, 0.1}).element, 0u);
  std::vector<std::uint8_t> masked(40, 0);
  std::fill_n(masked.begin(), 3, 1);
  EXPECT_EQ(tree_of(mesh, masked).closest({0.6, 0.2, 0.1}).element, 3u);
}

TEST(ClosestPoint, TakesManyCoincidentPoints) {
  constexpr std::size_t kCount = 30000;
  const std::vector<Vec3> points(kCount, Vec3(0.3, 0.2, 0.1));
  EXPECT_EQ(tree_of_points(points).closest({0.3, 0.2, 0.1}).element, 0u);
  EXPECT_EQ(tree_of_points(points).closest({5, 0, 0}).element, 0u);
  std::vector<Vec3> normals(kCount, Vec3::UnitX());
  for (std::size_t i = 777; i < kCount; ++i) normals[i] = Vec3::Zero();
  for (std::size_t i = 778; i < kCount; i += 2) normals[i] = Vec3::UnitY();
  const ClosestFilter facing_up{.normal = Vec3::UnitY(), .min_cosine = 0.5};
  EXPECT_EQ(tree_of_points(points, normals).closest({5, 0, 0}, facing_up).element, 778u);
}

TEST(ClosestPoint, KnowsTheBorderOfAPatch) {
  const ClosestPoint tree = tree_of(flat_patch(2, 2));
  EXPECT_TRUE(tree.closest({-1, 0.5, 0.2}).on_border);    // beyond the left edge
  EXPECT_TRUE(tree.closest({0, 0.5, 0.2}).on_border);     // right above it
  EXPECT_TRUE(tree.closest({-1, -1, 0}).on_border);       // a corner of the patch
  EXPECT_TRUE(tree.closest({3, 3, 0}).on_border);         // the vertex of the highest index
  EXPECT_TRUE(tree.closest({1, -1, 0}).on_border);        // a vertex between two border edges
  EXPECT_FALSE(tree.closest({0.5, 0.2, 0.2}).on_border);  // inside a triangle
  EXPECT_FALSE(tree.closest({0.5, 0.5, 0.2}).on_border);  // on an edge two triangles share
  EXPECT_FALSE(tree.closest({1, 1, 0.2}).on_border);      // the vertex in the middle
}

TEST(ClosestPoint, KnowsABorderVertexOfATriangleWithoutBorderEdges) {
  // The triangle {0, 4, 3} of this fan touches the border with vertex 0 alone.
  const std::vector<Vec3> positions{{0, 0, 0},  {2, 0, 0},  {2, 1, 0}, {1, 2, 1},
                                    {-1, 2, 1}, {-2, 1, 0}, {-2, 0, 0}};
  const std::vector<Triangle> triangles{{0, 3, 4}, {0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}};
  const ClosestPoint tree{std::span(positions), std::span(triangles)};
  const ClosestHit hit = tree.closest({0, -0.5, -0.1});
  EXPECT_EQ(hit.element, 0u);
  EXPECT_TRUE(hit.on_border);
}

TEST(ClosestPoint, CountsWhatIsMaskedAsMissingAtTheBorder) {
  const Mesh mesh = flat_patch(1, 1);
  EXPECT_FALSE(tree_of(mesh).closest({0.5, 0.5, 0.3}).on_border);
  EXPECT_TRUE(tree_of(mesh, {0, 1}).closest({0.5, 0.5, 0.3}).on_border);
  EXPECT_EQ(tree_of(mesh, {1, 0}).closest({0.9, 0.1, 0}).element, 1u);
}

TEST(ClosestPoint, PassesOverTrianglesWithoutArea) {
  // The diagonal of the square is bridged by a triangle without area and one that names a vertex
  // twice: nothing is found on them, and the surface is closed where the first stands.
  Mesh mesh = flat_patch(1, 1);
  mesh.positions.emplace_back(0.5, 0.5, 0);
  mesh.triangles = {{0, 3, 4}, {0, 0, 1}, {0, 1, 3}, {0, 4, 2}, {4, 3, 2}};
  const ClosestPoint tree = tree_of(mesh);
  for (const double t : {0.1, 0.3, 0.7, 0.9}) {
    const ClosestHit hit = tree.closest({t, t, 0.4});
    EXPECT_EQ(hit.element, 2u);
    EXPECT_FALSE(hit.on_border);
  }
  EXPECT_TRUE(tree.closest({0.5, -1, 0}).on_border);
}

TEST(ClosestPoint, OfASphereIsAsTheFormulaSays) {
  // Of directions within `angle` of a wanted one, that nearest to the query's is the query's own or
  // lies on the rim, which is (separation - angle) away from it.
  const std::vector<Vec3> points = sphere_points(20000);
  constexpr double kSpacing = 0.04;  // four times the side of the square a point has to itself
  const ClosestPoint tree = tree_of_points(points, points);
  Dice dice(8);
  const auto direction = [&] {
    return Vec3(dice.normal(1), dice.normal(1), dice.normal(1)).normalized();
  };
  for (int i = 0; i < 300; ++i) {
    const Vec3 way = direction(), wanted = direction();
    const double radius = dice.uniform(0.2, 3), angle = dice.uniform(0.1, 3);
    const ClosestHit hit =
        tree.closest(radius * way, {.normal = wanted, .min_cosine = std::cos(angle)});
    const double separation = std::acos(way.dot(wanted));
    const double apart = std::max(0.0, separation - angle);
    const double truth = std::sqrt(radius * radius + 1 - 2 * radius * std::cos(apart));
    ASSERT_TRUE(hit.found());
    EXPECT_GE(std::sqrt(hit.squared_distance), truth - 1e-9);
    EXPECT_LE(std::sqrt(hit.squared_distance), truth + kSpacing);
    EXPECT_GE(hit.normal.dot(wanted), std::cos(angle));
  }
}

TEST(ClosestPoint, LetsPassWhatIsJustAtTheAngle) {
  const std::vector<Vec3> points{{0, 0, 0}, {5, 0, 0}};
  const std::vector<Vec3> normals{{0.6, 0.8, 0}, Vec3::UnitY()};
  const ClosestPoint tree = tree_of_points(points, normals);
  EXPECT_EQ(tree.closest({1, 0, 0}, {.normal = Vec3::UnitY(), .min_cosine = 0.8}).element, 0u);
  const double above = std::nextafter(0.8, 1);
  EXPECT_EQ(tree.closest({1, 0, 0}, {.normal = Vec3::UnitY(), .min_cosine = above}).element, 1u);
  EXPECT_FALSE(tree.closest({1, 0, 0}, {.normal = -Vec3::UnitY(), .min_cosine = 0.1}).found());
}

TEST(ClosestPoint, DecidesTheAngleInDouble) {
  Dice dice(12);
  for (int i = 0; i < 200; ++i) {
    const Vec3 normal = Vec3(dice.normal(1), dice.normal(1), dice.normal(1)).normalized();
    const Vec3 wanted = Vec3(dice.normal(1), dice.normal(1), dice.normal(1)).normalized();
    const ClosestPoint tree = tree_of_points({{0, 0, 0}}, {normal});
    const double cosine = normal.dot(wanted), above = std::nextafter(cosine, 2);
    EXPECT_TRUE(tree.closest({1, 2, 3}, {.normal = wanted, .min_cosine = cosine}).found());
    EXPECT_FALSE(tree.closest({1, 2, 3}, {.normal = wanted, .min_cosine = above}).found());
  }
}

TEST(ClosestPoint, FindsSliversWhoseNormalIsMostlyRounding) {
  Dice dice(13);
  const auto somewhere = [&] {
    return Vec3(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1));
  };
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = somewhere(), b = somewhere(), middle = (a + b) / 2;
    const Vec3 aside = (b - a).cross(somewhere()).normalized();
    const std::vector<Vec3> positions{a, b, middle + 1e-11 * aside};
    const std::vector<Triangle> triangles{{0, 1, 2}};
    const ClosestPoint tree{std::span<const Vec3>(positions), std::span<const Triangle>(triangles)};
    // Straight out from its long edge, 0.5 away.
    const Vec3 out = (b - a).cross(somewhere()).normalized();
    const ClosestHit hit = tree.closest(middle + 0.5 * out, {.max_distance = 0.5 + 1e-9});
    ASSERT_TRUE(hit.found());
    EXPECT_NEAR(std::sqrt(hit.squared_distance), 0.5, 2e-11);  // the sliver's width
  }
}

TEST(ClosestPoint, PassesOverPointsWithoutNormalWhenFiltered) {
  const ClosestFilter lenient{.normal = Vec3::UnitX(), .min_cosine = -0.99};
  EXPECT_FALSE(tree_of_points({{0, 0, 0}}).closest({1, 0, 0}, lenient).found());
  const ClosestPoint mixed = tree_of_points({{0, 0, 0}, {9, 0, 0}}, {Vec3::Zero(), Vec3::UnitX()});
  EXPECT_EQ(mixed.closest({1, 0, 0}, lenient).element, 1u);
}

TEST(ClosestPoint, RefusesWhatHasNoAnswer) {
  Mesh mesh = flat_patch(1, 1);
  const ClosestPoint tree = tree_of(mesh);
  EXPECT_THROW(tree.closest({kNaN, 0, 0}), InvalidInput);
  EXPECT_THROW(tree.closest({0, 1e300, 0}), InvalidInput);
  EXPECT_THROW(tree.closest({0, 0, 0}, {.max_distance = kNaN}), InvalidInput);
  EXPECT_THROW(tree.closest({0, 0, 0}, {.min_cosine = kNaN}), InvalidInput);
  EXPECT_THROW(tree.closest({0, 0, 0}, {.normal = {kNaN, 0, 0}, .min_cosine = 0}), InvalidInput);
  EXPECT_THROW(tree_of(mesh, {0, 0, 0}), InvalidInput);
  EXPECT_THROW(tree_of_points({{0, 0, kNaN}}), InvalidInput);
  EXPECT_THROW(tree_of_points({{0, 0, 0}}, {{0, 3, 0}}), InvalidInput);
  EXPECT_THROW(tree_of_points({{0, 0, 0}}, {Vec3::UnitX(), Vec3::UnitX()}), InvalidInput);
  mesh.positions[3].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(tree_of(mesh), InvalidInput);
  EXPECT_NO_THROW(tree_of(mesh, {1, 1}));
  mesh.triangles[1][2] = 4;
  EXPECT_THROW(tree_of(mesh, {1, 1}), InvalidInput);
}

TEST(ClosestPoint, CanBeMoved) {
  ClosestPoint tree = tree_of(flat_patch(1, 1));
  const ClosestPoint moved = std::move(tree);
  EXPECT_TRUE(moved.closest({0, 0, 1}).found());
}

}  // namespace
}  // namespace regarment
