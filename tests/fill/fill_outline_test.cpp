#include "fill/fill_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "sheets.h"

namespace regarment {
namespace {

using test::directed_counts;
using test::edge_counts;
using test::sheet;

std::vector<Vec3> circle(int n, double radius, double z) {
  std::vector<Vec3> out;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    out.emplace_back(0.5 + radius * std::cos(a), 0.5 + radius * std::sin(a), z);
  }
  return out;
}

double area_of(const std::vector<Vec3>& outline, const Patch& patch) {
  std::vector<Vec3> all = outline;
  all.insert(all.end(), patch.inner.begin(), patch.inner.end());
  double area = 0;
  for (const Triangle& t : patch.triangles)
    area += (all[t[1]] - all[t[0]]).cross(all[t[2]] - all[t[0]]).z() / 2;
  return area;
}

TEST(FillOutline, ClosesAFlatCircleWithItsArea) {
  const Mesh plane = sheet(10, 0.1);
  const ClosestPoint cloth(plane.positions, plane.triangles);
  const std::vector<Vec3> outline = circle(40, 0.3, 0);
  const auto patch = fill_outline(outline, cloth);
  ASSERT_TRUE(patch.has_value());
  EXPECT_GT(patch->inner.size(), 20u);
  // A regular polygon; signed: seen from +z the triangles turn as the outline does.
  EXPECT_NEAR(area_of(outline, *patch), 20 * 0.09 * std::sin(2 * std::numbers::pi / 40), 1e-9);
}

TEST(FillOutline, GivesEveryEdgeOfTheOutlineOneTriangle) {
  const Mesh plane = sheet(10, 0.1);
  const ClosestPoint cloth(plane.positions, plane.triangles);
  const std::vector<Vec3> outline = circle(25, 0.4, 0.02);
  const auto patch = fill_outline(outline, cloth);
  ASSERT_TRUE(patch.has_value());
  std::size_t on_outline = 0;
  for (const auto& [edge, count] : edge_counts(patch->triangles)) {
    const std::uint32_t gap = edge.second - edge.first;
    const bool of_outline = edge.second < outline.size() && (gap == 1 || gap == outline.size() - 1);
    on_outline += of_outline ? 1 : 0;
    EXPECT_EQ(count, of_outline ? 1 : 2) << edge.first << " to " << edge.second;
  }
  EXPECT_EQ(on_outline, outline.size());
  for (const auto& [edge, count] : directed_counts(patch->triangles)) EXPECT_EQ(count, 1);
}

// The cloth lies 2 cm below the outline: inner points near it stay with it, those far away lie on
// the cloth.
TEST(FillOutline, GoesOverFromTheOutlineToTheCloth) {
  const Mesh plane = sheet(10, 0.1);
  const ClosestPoint cloth(plane.positions, plane.triangles);
  const auto patch = fill_outline(circle(200, 0.45, 0.02), cloth);
  ASSERT_TRUE(patch.has_value());
  double middle = 1, rim = 0;
  for (const Vec3& p : patch->inner) {
    const double r = std::hypot(p.x() - 0.5, p.y() - 0.5);
    if (r < 0.1) middle = std::min(middle, p.z());
    if (r > 0.43) rim = std::max(rim, p.z());
    EXPECT_GE(p.z(), 0);
    EXPECT_LE(p.z(), 0.02);
  }
  EXPECT_LT(middle, 0.001);
  EXPECT_GT(rim, 0.01);
}

TEST(FillOutline, ClosesATriangleWithItself) {
  const Mesh plane = sheet(2, 0.5);
  const ClosestPoint cloth(plane.positions, plane.triangles);
  const auto patch = fill_outline({{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, cloth);
  ASSERT_TRUE(patch.has_value());
  EXPECT_EQ(patch->triangles.size(), 1u);
  EXPECT_THROW(fill_outline({{0, 0, 0}, {1, 0, 0}}, cloth), InvalidInput);
}

// Points that coincide have no triangle: no answer, and no crash.
TEST(FillOutline, SurvivesAnOutlineWithoutArea) {
  const Mesh plane = sheet(2, 0.5);
  const ClosestPoint cloth(plane.positions, plane.triangles);
  EXPECT_NO_THROW(fill_outline(std::vector<Vec3>(4, Vec3(0.1, 0.1, 0)), cloth));
  EXPECT_NO_THROW(fill_outline({{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.3, 0, 0}}, cloth));
}

}  // namespace
}  // namespace regarment
