#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "report/chart_axis.h"
#include "report/chart_dots.h"
#include "report/chart_labels.h"
#include "report/svg_path.h"
#include "svg_paths.h"

namespace regarment {
namespace {

std::vector<std::string> texts(const AxisRange& range, int count) {
  std::vector<std::string> out;
  for (const AxisTick& tick : axis_ticks(range, count)) {
    EXPECT_GE(tick.value, range.low * (1 - 1e-6));
    EXPECT_LE(tick.value, range.high * (1 + 1e-6));
    out.push_back(tick.text);
  }
  return out;
}

using Texts = std::vector<std::string>;

TEST(ChartAxis, TicksAreRoundNumbers) {
  EXPECT_EQ(texts({0.0, 1.0}, 5), (Texts{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(texts({1.0, 500.0}, 5), (Texts{"100", "200", "300", "400", "500"}));
  EXPECT_EQ(texts({48.3, 71.9}, 5), (Texts{"50", "55", "60", "65", "70"}));
  // A step of 0.005 would leave two.
  EXPECT_EQ(texts({0.0061, 0.0199}, 5),
            (Texts{"0.008", "0.010", "0.012", "0.014", "0.016", "0.018"}));
}

TEST(ChartAxis, TicksBelowZeroHaveAMinus) {
  std::vector<AxisTick> ticks = axis_ticks({-10.0, 10.0}, 4);
  ASSERT_EQ(ticks.size(), 5u);
  EXPECT_EQ(ticks.front().text, "\u221210");
  EXPECT_EQ(ticks[2].text, "0");
}

TEST(ChartAxis, LogarithmicTicksGetFinerInANarrowRange) {
  EXPECT_EQ(texts({0.0029, 0.016, true}, 5), (Texts{"0.003", "0.005", "0.007", "0.01", "0.015"}));
  EXPECT_EQ(texts({1.0, 100.0, true}, 5), (Texts{"1", "2", "5", "10", "20", "50", "100"}));
  EXPECT_EQ(texts({1.0, 1e6, true}, 5),
            (Texts{"1", "10", "100", "1000", "10000", "100000", "1000000"}));
}

TEST(ChartAxis, ARangeShowsAllThatMustBeSeenAndMostOfTheRest) {
  std::vector<double> mostly;
  for (int i = 0; i <= 100; ++i) mostly.push_back(i);
  // 90 % of 0..100 is 5..95, and 97 must be seen too; 6 % of room at both ends.
  const AxisRange range = range_showing({50.0, 97.0, std::nan("")}, mostly, 0.9);
  EXPECT_NEAR(range.low, 5.0 - 0.06 * 92.0, 1e-9);
  EXPECT_NEAR(range.high, 97.0 + 0.06 * 92.0, 1e-9);
  EXPECT_FALSE(range.logarithmic);
}

TEST(ChartAxis, ARangeIsLogarithmicOnlyWhereThatFits) {
  EXPECT_TRUE(range_showing({1.0, 5.0}, {}, 1.0, AxisKind::Fitting).logarithmic);
  EXPECT_FALSE(range_showing({1.0, 3.0}, {}, 1.0, AxisKind::Fitting).logarithmic);
  EXPECT_FALSE(range_showing({0.0, 5.0}, {}, 1.0, AxisKind::Fitting).logarithmic);
  EXPECT_FALSE(range_showing({1.0, 5.0}, {}, 1.0).logarithmic);
}

TEST(ChartAxis, ARangeOfNothingOrOfOneValueIsStillARange) {
  for (const std::vector<double>& values :
       {std::vector<double>{}, {3.0, 3.0}, {std::nan("")}, {1e9, 1e9}, {0.0}}) {
    const AxisRange range = range_showing(values, {}, 0.9, AxisKind::Fitting);
    EXPECT_LT(range.low, range.high);
    EXPECT_FALSE(axis_ticks(range, 5).empty());
  }
}

TEST(ChartDots, AreAllOfThemWhenTheyAreFew) {
  EXPECT_EQ(dots_to_draw({1.0, std::nan(""), 3.0}, 2), (std::vector<std::size_t>{0, 2}));
}

TEST(ChartDots, KeepTheExtremesOfEachStretch) {
  Random random(3);
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(random.normal());
  const std::vector<std::size_t> dots = dots_to_draw(values, 100);
  EXPECT_LE(dots.size(), 100u);
  EXPECT_TRUE(std::is_sorted(dots.begin(), dots.end()));
  EXPECT_EQ(std::adjacent_find(dots.begin(), dots.end()), dots.end());
  for (std::size_t from = 0; from < 1000; from += 20) {  // 50 stretches of 20
    const auto begin = values.begin() + static_cast<long>(from);
    const auto [least, most] = std::minmax_element(begin, begin + 20);
    for (const auto extreme : {least, most}) {
      const auto at = static_cast<std::size_t>(extreme - values.begin());
      EXPECT_TRUE(std::binary_search(dots.begin(), dots.end(), at)) << at;
    }
  }
}

TEST(ChartLabels, AreMovedApartWithinTheirEnds) {
  std::vector<ChartLabel> labels = {
      {100.0, 98.0, "1", 0}, {100.0, 97.0, "2", 1}, {100.0, 99.0, "3", 2}, {100.0, 20.0, "4", 3}};
  spread_labels(labels, 10.0, 100.0);
  const std::vector<std::string> order = {"4", "2", "1", "3"};
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(labels[i].text, order[i]);
    EXPECT_GE(labels[i].y, 10.0);
    EXPECT_LE(labels[i].y, 100.0);
    const double gap = i == 0 ? 11.0 : labels[i].y - labels[i - 1].y;
    EXPECT_GE(gap, 11.0 - 1e-9);
  }
  EXPECT_EQ(labels[0].y, 20.0);  // was in nobody's way
}

TEST(ChartLabels, BesideEachOtherStayWhereTheyAre) {
  std::vector<ChartLabel> labels = {{100.0, 50.0, "1", 0}, {200.0, 51.0, "2", 1}};
  spread_labels(labels, 10.0, 100.0);
  EXPECT_EQ(labels[0].y, 50.0);
  EXPECT_EQ(labels[1].y, 51.0);
}

TEST(SvgPath, IsShort) {
  SvgPath path;
  path.move_to(12.34, 0.5);
  path.horizontal_to(12.0);
  path.vertical_to(20.5);
  path.dot(12.0, 10.0);
  EXPECT_EQ(path.text(), "m12.3 .5h-.3v20m0-10.5h0");
}

TEST(SvgPath, RoundingDoesNotAddUp) {
  SvgPath path;
  for (int i = 0; i <= 1000; ++i) path.dot(0.04 * i, 0.03 * i);
  const Points points = points_of(path.text());
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_NEAR(points[2 * std::size_t(i)].first, 0.04 * i, 0.0501);
    EXPECT_NEAR(points[2 * std::size_t(i)].second, 0.03 * i, 0.0501);
  }
}

}  // namespace
}  // namespace regarment
