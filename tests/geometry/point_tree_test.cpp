#include "geometry/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <stdexcept>

#include "geometry/parallel.h"

namespace regarment {
namespace {

/// Points of which many coincide or share coordinates, which is where trees go wrong.
std::vector<Vec3> clumped_points(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 p(uniform(random), uniform(random), uniform(random));
    if (i % 3 == 0) p = (p * 4).array().round() / 4;
    points.push_back(p);
  }
  return points;
}

std::vector<double> squared_distances(const std::vector<Vec3>& points, const Vec3& query) {
  std::vector<double> distances;
  for (const Vec3& p : points) distances.push_back((p - query).squaredNorm());
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(PointTree, FindsTheNearestAsBruteForceDoes) {
  for (const std::size_t count : {1u, 2u, 9u, 10u, 11u, 100u, 3000u}) {
    const std::vector<Vec3> points = clumped_points(count, 1);
    const PointTree tree(points);
    for (const Vec3& query : clumped_points(50, 2)) {
      const std::vector<double> truth = squared_distances(points, query);
      std::vector<PointNeighbour> found(12);
      const std::size_t n = tree.nearest(query, found);
      ASSERT_EQ(n, std::min<std::size_t>(count, 12));
      for (std::size_t i = 0; i < n; ++i) {
        EXPECT_EQ(found[i].squared_distance, truth[i]);
        EXPECT_EQ((points[found[i].index] - query).squaredNorm(), truth[i]);
      }
    }
  }
}

TEST(PointTree, NamesEachPointOnce) {
  const std::vector<Vec3> points(500, Vec3(1, 2, 3));
  const PointTree tree(points);
  std::vector<PointNeighbour> found(500);
  ASSERT_EQ(tree.nearest(Vec3(1, 2, 3), found), 500u);
  std::vector<bool> seen(500, false);
  for (const auto& [index, distance] : found) {
    EXPECT_EQ(distance, 0.0);
    EXPECT_FALSE(seen[index]);
    seen[index] = true;
  }
}

TEST(PointTree, KeepsWithinTheDistance) {
  const std::vector<Vec3> points = clumped_points(2000, 3);
  const PointTree tree(points);
  for (const Vec3& query : clumped_points(50, 4)) {
    const double radius = 0.2;
    const std::vector<double> truth = squared_distances(points, query);
    const auto inside =
        std::lower_bound(truth.begin(), truth.end(), radius * radius) - truth.begin();
    std::vector<PointNeighbour> found(2000);
    EXPECT_EQ(tree.nearest(query, found, radius), inside);
    tree.within(query, radius, found);
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.squared_distance < b.squared_distance; });
    ASSERT_GE(found.size(), inside);  // `within` holds points just at the radius too
    for (std::ptrdiff_t i = 0; i < inside; ++i) EXPECT_EQ(found[i].squared_distance, truth[i]);
    for (const auto& hit : found) EXPECT_LE(hit.squared_distance, radius * radius);
  }
}

TEST(PointTree, OfNothingFindsNothing) {
  const PointTree tree({});
  PointNeighbour hit;
  EXPECT_EQ(tree.nearest(Vec3::Zero(), {&hit, 1}), 0u);
  std::vector<PointNeighbour> found(3);
  tree.within(Vec3::Zero(), 1.0, found);
  EXPECT_TRUE(found.empty());
}

TEST(PointTree, OrdersEveryPointOnce) {
  const std::vector<Vec3> points = clumped_points(100'000, 5);  // enough to be built by threads
  const PointTree tree(points);
  std::vector<std::uint32_t> order(tree.order().begin(), tree.order().end());
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
}

TEST(ParallelFor, TouchesEachItemOnce) {
  std::vector<int> touched(10'007, 0);
  parallel_for(touched.size(), 100, [&](std::size_t begin, std::size_t end) {
    EXPECT_LE(end - begin, 100u);
    for (std::size_t i = begin; i < end; ++i) ++touched[i];
  });
  EXPECT_EQ(std::count(touched.begin(), touched.end(), 1), std::ssize(touched));
  parallel_for(0, 1, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(ParallelFor, PassesAnExceptionOn) {
  const auto fail_at_seven = [](std::size_t begin, std::size_t) {
    if (begin == 7) throw std::runtime_error("seven");
  };
  EXPECT_THROW(parallel_for(100, 1, fail_at_seven), std::runtime_error);
}

}  // namespace
}  // namespace regarment
