#include "analysis/beside_edge.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

constexpr double kRadius = 0.12;  // m, of the person
constexpr double kWaist = 1.0;    // m, the garment's upper edge

/// Points every 5 mm on an upright tube about (x, z), between two heights.
void add_tube(double x, double z, double radius, double from, double to, Analysis& analysis) {
  const int sides = static_cast<int>(2.0 * M_PI * radius / 0.005);
  for (double y = from; y < to; y += 0.005) {
    for (int s = 0; s < sides; ++s) {
      const double angle = 2.0 * M_PI * s / sides;
      analysis.scan.mesh.positions.emplace_back(x + radius * std::cos(angle), y,
                                                z + radius * std::sin(angle));
    }
  }
  analysis.labels.resize(analysis.scan.mesh.positions.size(), 0);
}

class BesideEdge : public testing::Test {
 protected:
  BesideEdge() {
    analysis_.scan.facts.spacing = 0.005;
    for (int s = 0; s < 90; ++s) {
      const double angle = 2.0 * M_PI * s / 90;
      const Vec3 out((kRadius + 0.01) * std::cos(angle), 0.0, (kRadius + 0.01) * std::sin(angle));
      edge_.points.emplace_back(out + Vec3(0.0, kWaist, 0.0));
      garment_.draped.emplace_back(out + Vec3(0.0, kWaist - 0.05, 0.0));
    }
  }

  std::optional<double> girth() const { return girth_beside(analysis_, garment_, edge_); }

  Analysis analysis_;
  GarmentAnalysis garment_;
  EdgeCurve edge_;
};

TEST_F(BesideEdge, IsTheGirthOfWhatShowsThere) {
  add_tube(0, 0, kRadius, 0.8, 1.2, analysis_);
  ASSERT_TRUE(girth().has_value());
  EXPECT_NEAR(*girth(), 2.0 * M_PI * kRadius, 0.005);  // 1 % of what a tape does
}

// Narrower above the edge than below it: the side away from the cloth counts.
TEST_F(BesideEdge, LooksAwayFromTheGarment) {
  add_tube(0, 0, kRadius, 0.8, 1.0, analysis_);
  add_tube(0, 0, 0.10, 1.0, 1.2, analysis_);
  ASSERT_TRUE(girth().has_value());
  EXPECT_NEAR(*girth(), 2.0 * M_PI * 0.10, 0.005);
  for (Vec3& p : garment_.draped) p.y() = kWaist + 0.05;
  ASSERT_TRUE(girth().has_value());
  EXPECT_NEAR(*girth(), 2.0 * M_PI * kRadius, 0.005);
}

TEST_F(BesideEdge, IsNotSeenUnderAnotherGarment) {
  add_tube(0, 0, kRadius, 0.8, 1.2, analysis_);
  analysis_.labels.assign(analysis_.labels.size(), 2);
  EXPECT_FALSE(girth().has_value());
}

TEST_F(BesideEdge, IsNotSeenBetweenTwoLegs) {
  add_tube(-0.065, 0, 0.05, 0.8, 1.2, analysis_);
  add_tube(0.065, 0, 0.05, 0.8, 1.2, analysis_);
  EXPECT_FALSE(girth().has_value());
}

TEST_F(BesideEdge, IsNotSeenWithAQuarterMissing) {
  add_tube(0, 0, kRadius, 0.8, 1.2, analysis_);
  std::erase_if(analysis_.scan.mesh.positions,
                [](const Vec3& p) { return p.x() > 0.0 && p.z() > 0.0; });
  analysis_.labels.resize(analysis_.scan.mesh.positions.size());
  EXPECT_FALSE(girth().has_value());
}

TEST_F(BesideEdge, IsNotSeenWhereNothingIs) {
  EXPECT_FALSE(girth().has_value());
  edge_.points.clear();
  EXPECT_FALSE(girth().has_value());
}

}  // namespace
}  // namespace regarment
