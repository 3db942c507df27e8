#include "segmentation/scan_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace regarment {
namespace {

TEST(ScanLinks, AreCheapAtACrease) {
  // A roof of two square sides that meet at a right angle, folded along x = 0.
  Scan scan;
  for (double x : {-0.01, 0.0, 0.01})
    for (double z : {0.0, 0.01}) scan.mesh.positions.emplace_back(x, -std::abs(x), z);
  scan.mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
  const double h = 1 / std::sqrt(2);
  scan.mesh.normals = {{-h, h, 0}, {-h, h, 0}, {h, h, 0}, {h, h, 0}, {h, h, 0}, {h, h, 0}};
  const std::vector<CutLink> links = scan_links(scan, std::vector<std::uint8_t>(6, 1));
  ASSERT_EQ(links.size(), 12U);
  for (const CutLink& link : links) {
    const bool across = (link.a < 2) != (link.b < 2);
    if (across)
      EXPECT_LT(link.cost, 0.06);
    else
      EXPECT_FLOAT_EQ(link.cost, 0.5F);
  }
}

TEST(ScanLinks, JoinNearestPointsOfACloudAndLeaveOutliersOut) {
  Scan scan;
  for (int i = 0; i < 20; ++i) scan.mesh.positions.emplace_back(0.01 * i, 0, 0);
  scan.mesh.normals.assign(20, Vec3::UnitY());
  scan.facts.spacing = 0.01;
  scan.outlier.assign(20, 0);
  scan.outlier[7] = 1;
  std::vector<std::uint8_t> wanted(20, 0);
  wanted[6] = wanted[7] = 1;
  std::vector<std::uint32_t> ends;
  for (const CutLink& link : scan_links(scan, wanted)) {
    EXPECT_EQ(link.a, 6U);
    EXPECT_FLOAT_EQ(link.cost, 0.5F);
    ends.push_back(link.b);
  }
  std::sort(ends.begin(), ends.end());
  // The six nearest; 2 and 10 are equally far.
  ASSERT_EQ(ends.size(), 6U);
  for (const std::uint32_t end : {3U, 4U, 5U, 8U, 9U})
    EXPECT_TRUE(std::find(ends.begin(), ends.end(), end) != ends.end()) << end;
  EXPECT_NE(ends.front() == 2, ends.back() == 10);
  EXPECT_THROW(scan_links(scan, std::vector<std::uint8_t>(3, 1)), InvalidInput);
}

}  // namespace
}  // namespace regarment
