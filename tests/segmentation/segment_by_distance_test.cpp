#include "segmentation/segment_by_distance.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.h"
#include "support/dice.h"

namespace regarment {
namespace {

/// A square garment of one metre in the plane y = 0, corners (0,0,0) and (1,0,1).
struct Square {
  Pattern pattern;
  std::vector<Vec3> draped;

  Square() {
    draped = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    pattern.flat = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    pattern.triangles = {{0, 2, 1}, {0, 3, 2}};
  }
};

Scan scan_of(const std::vector<Vec3>& points) {
  Scan scan;
  scan.mesh.positions = points;
  return scan;
}

TEST(SegmentByDistance, TakesWhatLiesWithinTheThresholdAndNothingElse) {
  const Square square;
  // Above and below the middle, beside an edge (distance 3/64), off a corner (5/64 by 3 and 4).
  // Binary fractions, so that a vertex at the threshold is exactly there.
  const Scan scan = scan_of({{0.5, 0, 0.5},
                             {0.5, 3.0 / 64, 0.25},
                             {0.25, -3.0 / 64, 0.5},
                             {1 + 3.0 / 64, 0, 0.5},
                             {1 + 3.0 / 64, 0, 1 + 4.0 / 64},
                             {0.5, 4.0 / 64, 0.5},
                             {-4.0 / 64, 0, 0.5},
                             {0.5, 3, 0.5}});
  Labels labels;
  segment_by_distance(scan, square.pattern, square.draped, 3.0 / 64, 2, labels);
  EXPECT_EQ(labels.label, (std::vector<std::uint8_t>{2, 2, 2, 2, 0, 0, 0, 0}));
  const auto beyond = [](double share) { return static_cast<float>(1 - std::exp(1 - share) / 2); };
  EXPECT_EQ(labels.probability, (std::vector<float>{1, 0.5F, 0.5F, 0.5F, beyond(5.0 / 3),
                                                    beyond(4.0 / 3), beyond(4.0 / 3), 1}));
  Labels wider;
  segment_by_distance(scan, square.pattern, square.draped, 5.0 / 64, 1, wider);
  EXPECT_EQ(wider.label, (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 1, 1, 0}));
}

/// A garment round a ball: meridians and circles of latitude, `rows` of them from pole to pole.
struct Ball {
  Pattern pattern;
  std::vector<Vec3> draped;

  Ball(double radius, int rows) {
    const int around = 2 * rows;
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j < around; ++j) {
        const double theta = std::numbers::pi * i / rows, phi = std::numbers::pi * j / rows;
        draped.emplace_back(radius * std::sin(theta) * std::cos(phi), radius * std::cos(theta),
                            radius * std::sin(theta) * std::sin(phi));
      }
    pattern.flat.resize(draped.size());
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < around; ++j) {
        const auto at = [&](int row, int column) {
          return static_cast<std::uint32_t>(row * around + column % around);
        };
        pattern.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
        pattern.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
      }
  }
};

TEST(SegmentByDistance, TakesAShellRoundABall) {
  constexpr double kRadius = 0.3, kThreshold = 0.02;
  const Ball ball(kRadius, 90);
  // The facets lie inside of the ball, by at most the sagitta of their half diagonal.
  const double half_diagonal = kRadius * std::numbers::pi / 90 / std::sqrt(2);
  const double sagitta = half_diagonal * half_diagonal / (2 * kRadius);
  test::Dice dice(5);
  std::vector<Vec3> points;
  std::vector<double> distance;
  while (points.size() < 5000) {
    const Vec3 direction(dice.normal(1), dice.normal(1), dice.normal(1));
    distance.push_back(dice.uniform(-0.05, 0.05));
    points.push_back((kRadius + distance.back()) * direction.normalized());
  }
  Labels labels;
  segment_by_distance(scan_of(points), ball.pattern, ball.draped, kThreshold, 1, labels);
  int taken = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double off = std::abs(distance[v]);
    if (std::abs(off - kThreshold) > 2 * sagitta) {
      ASSERT_EQ(labels.label[v], off < kThreshold ? 1 : 0) << distance[v];
    }
    taken += labels.label[v];
    const double share = off / kThreshold;
    // The steepest change of probability with distance is 1 / (2 threshold).
    ASSERT_NEAR(labels.probability[v], share < 1 ? 1 - share / 2 : 1 - std::exp(1 - share) / 2,
                2 * sagitta / (2 * kThreshold));
  }
  EXPECT_NEAR(taken, 0.4 * 5000, 200);
}

TEST(SegmentByDistance, LeavesOuterGarmentsAndOutliersAlone) {
  const Square square;
  Scan scan = scan_of({{0.1, 0, 0.1}, {0.2, 0, 0.1}, {0.3, 0.008, 0.1}, {0.4, 0.008, 0.1}});
  scan.outlier = {0, 1, 0, 0};
  Labels labels{{1, 0, 0, 0}, {0.75F, 0.9F, 0.55F, 1.0F}};
  segment_by_distance(scan, square.pattern, square.draped, 0.01, 2, labels);
  EXPECT_EQ(labels.label, (std::vector<std::uint8_t>{1, 0, 2, 2}));
  EXPECT_EQ(labels.probability[0], 0.75F);
  EXPECT_EQ(labels.probability[1], 0.9F);
  EXPECT_EQ(labels.probability[2], 0.55F);  // it was no surer of the garment before
  EXPECT_FLOAT_EQ(labels.probability[3], 0.6F);
}

TEST(SegmentByDistance, OfNothingLabelsNothing) {
  const Square square;
  Labels labels;
  segment_by_distance(scan_of({}), square.pattern, square.draped, 0.01, 1, labels);
  EXPECT_TRUE(labels.label.empty());
  segment_by_distance(scan_of({{0, 0, 0}}), Pattern(), {}, 0.01, 1, labels);
  EXPECT_EQ(labels.label, std::vector<std::uint8_t>{0});
  EXPECT_EQ(labels.probability, std::vector<float>{1.0F});
}

TEST(SegmentByDistance, RefusesWhatDoesNotFit) {
  const Square square;
  const Scan scan = scan_of({{0, 0, 0}, {1, 1, 1}});
  const auto refused = [&](double threshold, int layer, Labels labels,
                           const std::vector<Vec3>& draped, const Scan& of) {
    EXPECT_THROW(segment_by_distance(of, square.pattern, draped, threshold, layer, labels),
                 InvalidInput);
  };
  for (const double threshold : {0.0, -0.01, std::nan(""), HUGE_VAL})
    refused(threshold, 1, {}, square.draped, scan);
  for (const int layer : {-1, 0, 256}) refused(0.01, layer, {}, square.draped, scan);
  refused(0.01, 1, {}, {{0, 0, 0}}, scan);
  refused(0.01, 1, {{0}, {1.0F}}, square.draped, scan);
  refused(0.01, 1, {{0, 0}, {1.0F}}, square.draped, scan);
  Scan marked = scan;
  marked.outlier = {0};
  refused(0.01, 1, {}, square.draped, marked);
}

}  // namespace
}  // namespace regarment
