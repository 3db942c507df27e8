#pragma once

#include <string>
#include <vector>

#include "evaluation/group_statistics.h"

namespace regarment {

/// The errors of one measurement in the plot.
struct MeasurementErrors {
  std::string name;
  std::vector<double> errors_cm;                    // at least one
  double bias_cm = 0;                               // their mean
  std::optional<double> bias_low_cm, bias_high_cm;  // 95 %
  std::optional<double> limit_cm;                   // of ISO 20685 on the bias
};

/// A measurement group's errors, in the groups' order; groups without errors are left out.
std::vector<MeasurementErrors> measurement_errors(const std::vector<EvaluatedScan>& scans,
                                                  const std::vector<GroupStatistics>& groups);

/// Size of the plot, in units about a pixel each.
inline constexpr int kMeasurementPlotWidth = 720;
int measurement_plot_height(std::size_t measurements);

/// The inside of an SVG: a row per measurement with a dot for each error, a box over the middle
/// half with the median, the mean with its 95 % interval below, and the limit on it as a band.
/// Errors beyond the middle 98 % of all may lie on the edge.
std::string measurement_plot(const std::vector<MeasurementErrors>& rows);

}  // namespace regarment
