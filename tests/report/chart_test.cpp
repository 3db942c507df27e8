#include "report/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.h"
#include "svg_paths.h"

namespace regarment {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 0.051;  // of a coordinate

Points dots_of(const std::string& svg, int style) {
  const Points all = points_of(paths_of(svg, "dots s" + std::to_string(style)).at(0));
  Points out;
  for (std::size_t i = 0; i < all.size(); i += 2) {
    EXPECT_EQ(all[i], all[i + 1]);  // a dot has no length
    out.push_back(all[i]);
  }
  return out;
}

Points line_of(const std::string& svg, int style) {
  return points_of(paths_of(svg, "line s" + std::to_string(style)).at(0));
}

Chart chart_of(std::vector<double> tried, std::vector<double> found, AxisRange range) {
  Chart chart;
  chart.range = range;
  chart.runs = {{std::move(tried), std::move(found), 1, 0}};
  return chart;
}

// The first two values are the ends of the range, which fixes the scale the others are read by.
TEST(Chart, DotsReadBackAreTheValues) {
  const std::vector<double> values = {2.0, 12.0, 4.5, kNone, 7.0, 10.0};
  const Points dots = dots_of(draw_chart(chart_of(values, values, {2.0, 12.0})), 0);
  ASSERT_EQ(dots.size(), 5u);
  const double low = dots[0].second, high = dots[1].second, step = dots[1].first - dots[0].first;
  EXPECT_GT(low, high);  // larger is further up
  const double value_of_rounding = kRounding * 10.0 / (low - high);
  const std::size_t evaluation[] = {0, 1, 2, 4, 5};
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const double value = 2.0 + 10.0 * (low - dots[i].second) / (low - high);
    EXPECT_NEAR(value, values[evaluation[i]], 2.0 * value_of_rounding);
    EXPECT_NEAR((dots[i].first - dots[0].first) / step, double(evaluation[i]), 0.02);
  }
}

TEST(Chart, ALogarithmicAxisPutsEqualRatiosEquallyFarApart) {
  const std::vector<double> values = {1.0, 10.0, 100.0};
  const Points dots = dots_of(draw_chart(chart_of(values, values, {1.0, 100.0, true})), 0);
  EXPECT_NEAR(dots[1].second, (dots[0].second + dots[2].second) / 2.0, 2 * kRounding);
}

TEST(Chart, ValuesBeyondTheRangeLieOnItsEdge) {
  const std::vector<double> values = {0.0, 1.0, -5.0, 99.0};
  const Points dots = dots_of(draw_chart(chart_of(values, values, {0.0, 1.0})), 0);
  EXPECT_EQ(dots[2].second, dots[0].second);
  EXPECT_EQ(dots[3].second, dots[1].second);
}

TEST(Chart, LinesStepWhereABetterOneWasFound) {
  const std::vector<double> tried = {0.0, 1.0, 0.75, 0.5, 0.75};
  const std::vector<double> found = {kNone, 1.0, 1.0, 0.5, 0.5};
  const std::string svg = draw_chart(chart_of(tried, found, {0.0, 1.0}));
  const Points dots = dots_of(svg, 0), line = line_of(svg, 0);
  ASSERT_EQ(line.size(), 5u);
  EXPECT_EQ(line[0], dots[1]);
  EXPECT_EQ(line[1], std::pair(dots[3].first, dots[1].second));
  const auto near = [](const auto& a, const auto& b) {
    EXPECT_NEAR(a.first, b.first, 1e-9);
    EXPECT_NEAR(a.second, b.second, 1e-9);
  };
  near(line[2], dots[3]);
  near(line[4], std::pair(dots[4].first, dots[3].second));
}

TEST(Chart, LevelsAreDrawnOnlyWithinTheRange) {
  Chart chart = chart_of({0.0, 1.0}, {0.0, 0.0}, {0.0, 1.0});
  chart.levels = {{0.5, "truth"}, {1.5, "bound"}, {-0.5, "bound"}};
  const std::string svg = draw_chart(chart);
  EXPECT_TRUE(paths_of(svg, "level bound").empty());
  const Points truth = points_of(paths_of(svg, "level truth").at(0));
  const Points dots = dots_of(svg, 0);
  EXPECT_NEAR(truth[0].second, (dots[0].second + dots[1].second) / 2.0, 2 * kRounding);
}

TEST(Chart, EachRunHasItsNumberItsStyleAndItsEnd) {
  Chart chart;
  chart.runs = {{{0.1, 0.2}, {0.1, 0.1}, 7, 1}, {{0.9, 0.8, 0.7}, {0.9, 0.8, 0.7}, 12, 0}};
  const std::string svg = draw_chart(chart);
  EXPECT_NE(svg.find(">7</text>"), std::string::npos);
  EXPECT_NE(svg.find(">12</text>"), std::string::npos);
  EXPECT_LT(line_of(svg, 1).back().first, line_of(svg, 0).back().first);
}

TEST(Chart, RunsWithoutAnythingToShowAreNotDrawn) {
  const std::string svg = draw_chart(chart_of({kNone, kNone}, {kNone, kNone}, {0.0, 1.0}));
  EXPECT_TRUE(paths_of(svg, "line s0").empty());
  EXPECT_TRUE(paths_of(svg, "dots s0").empty());
  EXPECT_EQ(svg.find("class=\"label"), std::string::npos);
}

TEST(Chart, StaysSmallHoweverLongTheSearch) {
  Random random(1);
  for (const std::size_t length : {500u, 100'000u}) {
    Chart chart;
    for (int r = 0; r < 3; ++r) {
      ChartRun& run = chart.runs.emplace_back();
      for (std::size_t i = 0; i < length; ++i) {
        run.tried.push_back(random.uniform());
        run.found.push_back(1.0 - double(i) / double(length));  // better at every step
      }
    }
    // Eleven of these, for a garment with seven dimensions, stay below 150 KB a run of three.
    EXPECT_LT(draw_chart(chart).size(), 30'000u) << length;
  }
}

}  // namespace
}  // namespace regarment
