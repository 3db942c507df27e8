#include "evaluation/measurement_plot.h"

#include <gtest/gtest.h>

#include "evaluations.h"
#include "support/texts.h"

namespace regarment {
namespace {

TEST(MeasurementErrors, AreThoseOfTheirMeasurement) {
  std::vector<EvaluatedScan> scans = {skirt_scan("a", {1, 2}), skirt_scan("b", {3, -4}),
                                      failed("c")};
  scans[1].about.dimensions[1].observable = false;
  const auto rows = measurement_errors(scans, group_statistics(scans));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].name, "skirt length");
  ASSERT_EQ(rows[0].errors_cm.size(), 2u);
  EXPECT_NEAR(rows[0].errors_cm[1], 3, 1e-9);
  EXPECT_NEAR(rows[0].bias_cm, 2, 1e-9);
  ASSERT_EQ(rows[1].errors_cm.size(), 1u);
  EXPECT_NEAR(rows[1].errors_cm[0], 2, 1e-9);
}

TEST(MeasurementPlot, HasADotForEachErrorAndANameForEachRow) {
  const std::string svg =
      measurement_plot({{"one", {-1, 0, 1}, 0, -1.1, 1.1, 0.5}, {"two", {2}, 2, {}, {}, {}}});
  const auto dots = svg.find("dots s0");
  EXPECT_EQ(count(svg.substr(dots, svg.find("/>", dots) - dots), "h0"), 4u);
  EXPECT_EQ(count(svg, ">one<"), 1u);
  EXPECT_EQ(count(svg, ">two<"), 1u);
  EXPECT_GT(measurement_plot_height(2), measurement_plot_height(1));
}

TEST(MeasurementPlot, EscapesNames) {
  EXPECT_EQ(count(measurement_plot({{"<b>", {1}, 1, {}, {}, {}}}), "<b>"), 0u);
}

TEST(MeasurementPlot, StandsWildErrorsAndNone) {
  EXPECT_EQ(count(measurement_plot({{"a", {1e6, 0, -3}, 0, {}, {}, {}}}), "nan"), 0u);
  EXPECT_EQ(count(measurement_plot({}), "nan"), 0u);
}

}  // namespace
}  // namespace regarment
