#include "evaluation/error_plots.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "evaluations.h"
#include "support/texts.h"

namespace regarment {
namespace {

TEST(PlotPoints, AreWhatIsSeenAndFound) {
  EvaluatedScan scan = skirt_scan("a", {1, 2, 3, 4});
  scan.about.dimensions[0].observable = false;
  scan.found[1].reset();
  scan.found[2]->observable = false;
  const auto points = plot_points({scan, failed("b")});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_TRUE(points[0].flagged);
  EXPECT_NEAR(points[1].estimate_cm - points[1].truth_cm, 4, 1e-12);
}

TEST(AgreementPlot, DrawsADotForEachPoint) {
  const std::string svg = agreement_plot({{50, 51, false}, {60, 66, false}, {70, 70, true}});
  EXPECT_EQ(count(svg, "h0"), 3u);
  EXPECT_EQ(count(svg, "dots s0"), 1u);
  EXPECT_EQ(count(svg, "dots s4"), 1u);
}

// Where truth and estimate are equal the dot lies on the line: the end of the line is such a point.
TEST(AgreementPlot, StandsOnePoint) {
  EXPECT_EQ(count(agreement_plot({{50, 50, false}}), "h0"), 1u);
}

TEST(DifferencePlot, HasLimitsWhereThereIsASpread) {
  const std::vector<PlotPoint> points = {{50, 51, false}, {60, 64, false}};
  EXPECT_EQ(count(difference_plot(points, error_statistics({{50, 51, {}, {}}, {60, 64, {}, {}}})),
                  "level bound"),
            2u);
  EXPECT_EQ(
      count(difference_plot({points[0]}, error_statistics({{50, 51, {}, {}}})), "level bound"), 0u);
}

TEST(DifferencePlot, KeepsWildErrorsOnThePaper) {
  std::vector<PlotPoint> points(100, {50, 50.5, false});
  points.push_back({50, 9000, false});
  std::vector<Sample> samples;
  samples.reserve(points.size());
  for (const PlotPoint& p : points) samples.push_back({p.truth_cm, p.estimate_cm, {}, {}});
  const std::string svg = difference_plot(points, error_statistics(samples));
  EXPECT_EQ(count(svg, "h0"), 101u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace regarment
