#include "fill/fill_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "sheets.h"

// A skirt as an upright tube round the y axis, its scan the same tube with squares missing.

namespace regarment {
namespace {

using test::directed_counts;
using test::edge_counts;

constexpr int kAround = 120, kRings = 50;
constexpr double kRadius = 0.17, kStep = 0.01;  // m

Vec3 on_tube(double angle, double y, double radius = kRadius) {
  return {radius * std::sin(angle), y, radius * std::cos(angle)};
}

/// The part of the tube whose squares (around, ring) are not in `hole`; outside faces out.
Mesh tube(const std::function<bool(int, int)>& hole = {}, double radius = kRadius) {
  Mesh mesh;
  for (int r = 0; r <= kRings; ++r)
    for (int a = 0; a < kAround; ++a)
      mesh.positions.push_back(on_tube(2 * std::numbers::pi * a / kAround, kStep * r, radius));
  const auto at = [](int a, int r) {
    return static_cast<std::uint32_t>(r * kAround + a % kAround);
  };
  for (int r = 0; r < kRings; ++r)
    for (int a = 0; a < kAround; ++a) {
      if (hole && hole(a, r)) continue;
      mesh.triangles.push_back({at(a, r), at(a + 1, r), at(a + 1, r + 1)});
      mesh.triangles.push_back({at(a, r), at(a + 1, r + 1), at(a, r + 1)});
    }
  return mesh;
}

FillCloth cloth(double radius = kRadius) {
  const Mesh whole = tube({}, radius);
  FillCloth out{whole.positions, whole.triangles, {{}, {}}};
  for (int a = 0; a < kAround; ++a) {
    const double angle = 2 * std::numbers::pi * a / kAround;
    out.edges[0].push_back(on_tube(angle, 0, radius));                // hem: counter-clockwise
    out.edges[1].push_back(on_tube(-angle, kStep * kRings, radius));  // waist: clockwise
  }
  return out;
}

std::vector<std::uint8_t> ones(const Mesh& mesh) {
  return std::vector<std::uint8_t>(mesh.positions.size(), 1);
}

FilledScan filled(const Mesh& scan, const FillCloth& garment = cloth()) {
  return fill_scan(scan, ones(scan), {}, {garment}, 0);
}

bool in_window(int a, int r) { return a >= 20 && a < 32 && r >= 20 && r < 30; }

/// Edges of one triangle alone that do not lie at the ends of the tube.
std::size_t open_edges(const Mesh& mesh) {
  std::size_t count = 0;
  for (const auto& [edge, triangles] : edge_counts(mesh.triangles)) {
    const auto at_end = [&](std::uint32_t v) {
      const double y = mesh.positions[v].y();
      return std::abs(y) < 1e-6 || std::abs(y - kStep * kRings) < 1e-6;
    };
    EXPECT_LE(triangles, 2);
    count += triangles == 1 && !(at_end(edge.first) && at_end(edge.second)) ? 1 : 0;
  }
  return count;
}

TEST(FillScan, LeavesNoEdgeOfAHoleOpen) {
  const Mesh scan = tube(in_window);
  ASSERT_EQ(open_edges(scan), 44u);  // 12 + 10 squares, twice
  const FilledScan out = filled(scan);
  EXPECT_EQ(out.holes, 1u);
  EXPECT_EQ(open_edges(out.mesh), 0u);
  for (const auto& [edge, count] : directed_counts(out.mesh.triangles)) EXPECT_EQ(count, 1);
}

TEST(FillScan, FillsAsMuchAsIsMissing) {
  const FilledScan out = filled(tube(in_window));
  const double width = 2 * kRadius * std::sin(std::numbers::pi / kAround);  // of one square
  EXPECT_NEAR(out.area, 12 * width * 10 * kStep, 0.02 * 12 * width * 10 * kStep);
}

TEST(FillScan, KeepsTheScanInFrontAndMarksWhatItAdded) {
  const Mesh scan = tube(in_window);
  const FilledScan out = filled(scan);
  ASSERT_EQ(out.filled.size(), out.mesh.positions.size());
  ASSERT_GT(out.mesh.positions.size(), scan.positions.size());
  for (std::size_t v = 0; v < out.mesh.positions.size(); ++v) {
    EXPECT_EQ(out.filled[v], v < scan.positions.size() ? 0 : 1);
    if (v < scan.positions.size()) {
      EXPECT_EQ(out.mesh.positions[v], scan.positions[v]);
    }
  }
  ASSERT_GT(out.mesh.triangles.size(), scan.triangles.size());
  EXPECT_TRUE(std::equal(scan.triangles.begin(), scan.triangles.end(), out.mesh.triangles.begin()));
}

// The tube bulges 5 mm beyond the scan: what is added lies between the two.
TEST(FillScan, FollowsTheCloth) {
  const Mesh scan = tube(in_window);
  const FilledScan out = filled(scan, cloth(kRadius + 0.005));
  double farthest = 0;
  for (std::size_t v = scan.positions.size(); v < out.mesh.positions.size(); ++v) {
    const Vec3& p = out.mesh.positions[v];
    farthest = std::max(farthest, std::hypot(p.x(), p.z()));
    EXPECT_GT(std::hypot(p.x(), p.z()), kRadius - 0.001);
  }
  EXPECT_GT(farthest, kRadius + 0.0005);
  EXPECT_LT(farthest, kRadius + 0.006);
}

TEST(FillScan, AddsNothingWhereThereIsNoHole) {
  const Mesh scan = tube();
  const FilledScan out = filled(scan);
  EXPECT_EQ(out.holes, 0u);
  EXPECT_EQ(out.mesh.positions.size(), scan.positions.size());
  EXPECT_EQ(out.mesh.triangles.size(), scan.triangles.size());
}

// The cloth is 2 cm longer than the scan shows at hem and waist: no hole.
TEST(FillScan, AddsNothingBeyondTheScansOwnEnds) {
  const Mesh scan = tube([](int, int r) { return r < 2 || r >= kRings - 2; });
  EXPECT_EQ(filled(scan).mesh.triangles.size(), scan.triangles.size());
}

// A hole that is open below is closed down to the garment's hem.
TEST(FillScan, ClosesAHoleThatRunsOutUnderTheHem) {
  const Mesh scan = tube([](int a, int r) { return a >= 20 && a < 50 && r < 30; });
  const FilledScan out = filled(scan);
  EXPECT_EQ(out.holes, 1u);
  EXPECT_EQ(open_edges(out.mesh), 0u);
  const double width = 2 * kRadius * std::sin(std::numbers::pi / kAround);
  // 5 %: new points at the hem lie on its chords, and inner ones between rings.
  EXPECT_NEAR(out.area, 30 * width * 30 * kStep, 0.05 * 30 * width * 30 * kStep);
}

// A column that is missing from waist to hem is closed between both.
TEST(FillScan, ClosesAMissingColumn) {
  const Mesh scan = tube([](int a, int) { return a >= 20 && a < 50; });
  const FilledScan out = filled(scan);
  EXPECT_EQ(out.holes, 1u);
  EXPECT_EQ(open_edges(out.mesh), 0u);
}

TEST(FillScan, LeavesHolesOfThePersonAlone) {
  const Mesh scan = tube(in_window);
  const std::vector<std::uint8_t> person(scan.positions.size(), 0);
  EXPECT_EQ(fill_scan(scan, person, {}, {cloth()}, 0).holes, 0u);
}

// As in an STL file every triangle has vertices of its own: its borders are not holes.
TEST(FillScan, SeesTrianglesThatShareNoVertices) {
  const Mesh scan = tube(in_window);
  Mesh loose;
  for (const Triangle& t : scan.triangles) {
    const auto first = static_cast<std::uint32_t>(loose.positions.size());
    for (const std::uint32_t v : t) loose.positions.push_back(scan.positions[v]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  const FilledScan out = filled(loose);
  EXPECT_EQ(out.holes, 1u);
  EXPECT_NEAR(out.area, filled(scan).area, 1e-12);
}

TEST(FillScan, GivesACloudPointsAtItsOwnSpacing) {
  Mesh scan = tube(in_window);
  std::vector<Vec3> points;
  for (int r = 0; r <= kRings; ++r)
    for (int a = 0; a < kAround; ++a)
      if (!in_window(a, r)) points.push_back(scan.positions[r * kAround + a]);
  scan.positions = points;
  scan.triangles.clear();
  const FilledScan out = fill_scan(scan, ones(scan), {}, {cloth()}, 0.009);
  const std::size_t added = out.mesh.positions.size() - points.size();
  EXPECT_TRUE(out.mesh.is_cloud());
  // 12 x 10 squares of 0.9 x 1 cm, less what lies nearer than 2.7 cm to the points around.
  EXPECT_GT(added, 20u);
  EXPECT_LT(added, 110u);
  for (std::size_t v = points.size(); v < out.mesh.positions.size(); ++v) {
    EXPECT_EQ(out.filled[v], 1);
    const Vec3& p = out.mesh.positions[v];
    EXPECT_GT(p.y(), 0.2);
    EXPECT_LT(p.y(), 0.3);
  }
}

TEST(FillScan, AddsNoPointsToAWholeCloud) {
  Mesh scan = tube();
  scan.triangles.clear();
  EXPECT_EQ(fill_scan(scan, ones(scan), {}, {cloth()}, 0.009).mesh.positions.size(),
            scan.positions.size());
}

// A stray point in the middle of a hole is no surface.
TEST(FillScan, FillsAroundOutliersOfACloud) {
  Mesh scan = tube(in_window);
  scan.triangles.clear();
  std::vector<std::uint8_t> outlier(scan.positions.size(), 0);
  for (int r = 21; r < 30; ++r)
    for (int a = 21; a < 32; ++a) outlier[static_cast<std::size_t>(r * kAround + a)] = 1;
  const auto size_of = [&](std::span<const std::uint8_t> marks) {
    return fill_scan(scan, ones(scan), marks, {cloth()}, 0.009).mesh.positions.size();
  };
  EXPECT_EQ(size_of({}), scan.positions.size());
  EXPECT_GT(size_of(outlier), scan.positions.size() + 20);
}

TEST(FillScan, RefusesLabelsOfAnotherSize) {
  EXPECT_THROW(fill_scan(tube(), {}, {}, {cloth()}, 0), InvalidInput);
}

}  // namespace
}  // namespace regarment
