#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluated_scan.h"
#include "evaluation/statistics.h"

namespace regarment {

/// A dimension in a plot.
struct PlotPoint {
  double truth_cm = 0, estimate_cm = 0;
  bool flagged = false;  // the program said it is not measurable
};

/// Every dimension that is not hidden and was estimated.
std::vector<PlotPoint> plot_points(const std::vector<EvaluatedScan>& scans);

/// Size of both plots, in their own units, about a pixel each.
inline constexpr int kPlotWidth = 460, kPlotHeight = 330;

/// The inside of an SVG: estimate over truth, with the line where both are equal.
std::string agreement_plot(const std::vector<PlotPoint>& points);

/// The inside of an SVG: error over the mean of truth and estimate, with the mean error and, where
/// there is a standard deviation, the limits 1.96 of them away [Bland and Altman 1986]. Errors
/// beyond the middle 98 % may lie on the edge.
std::string difference_plot(const std::vector<PlotPoint>& points, const ErrorStatistics& errors);

}  // namespace regarment
