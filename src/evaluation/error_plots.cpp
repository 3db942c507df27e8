#include "evaluation/error_plots.h"

#include <algorithm>
#include <cmath>

#include "report/chart_axis.h"
#include "report/svg_path.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr double kLeft = 48, kRight = 14, kTop = 24, kBottom = 40;
constexpr double kShownErrors = 0.98;

// Where values lie on a plot.
struct Frame {
  AxisRange across, up;
  double x(double value) const {
    return kLeft + std::clamp(across.share(value), 0.0, 1.0) * (kPlotWidth - kLeft - kRight);
  }
  double y(double value) const {
    return kPlotHeight - kBottom -
           std::clamp(up.share(value), 0.0, 1.0) * (kPlotHeight - kTop - kBottom);
  }
};

std::string axes(const Frame& frame, const std::string& across, const std::string& up) {
  SvgPath grid, ends;
  std::string words;
  for (const AxisTick& tick : axis_ticks(frame.up, 6)) {
    grid.move_to(kLeft, frame.y(tick.value));
    grid.horizontal_to(kPlotWidth - kRight);
    words += text_element(kLeft - 6, frame.y(tick.value) + 4, "y", tick.text);
  }
  ends.move_to(kLeft, kPlotHeight - kBottom);
  ends.horizontal_to(kPlotWidth - kRight);
  for (const AxisTick& tick : axis_ticks(frame.across, 7)) {
    ends.move_to(frame.x(tick.value), kPlotHeight - kBottom);
    ends.vertical_to(kPlotHeight - kBottom + 4);
    words += text_element(frame.x(tick.value), kPlotHeight - kBottom + 17, "x", tick.text);
  }
  words += text_element(0.5 * (kLeft + kPlotWidth - kRight), kPlotHeight - 6, "x", across);
  return path_element("grid", grid) + path_element("ends", ends) + words +
         text_element(0, 10, "name", up);
}

std::string level(const Frame& frame, double value, const std::string& kind) {
  SvgPath line;
  line.move_to(kLeft, frame.y(value));
  line.horizontal_to(kPlotWidth - kRight);
  return path_element("level " + kind, line);
}

template <typename Across, typename Up>
std::string dots(const std::vector<PlotPoint>& points, const Frame& frame, Across across, Up up) {
  SvgPath seen, flagged;
  for (const PlotPoint& point : points) {
    (point.flagged ? flagged : seen).dot(frame.x(across(point)), frame.y(up(point)));
  }
  return path_element("dots s4", flagged) + path_element("dots s0", seen);
}

}  // namespace

std::vector<PlotPoint> plot_points(const std::vector<EvaluatedScan>& scans) {
  std::vector<PlotPoint> out;
  for (const EvaluatedScan& scan : scans) {
    for (std::size_t d = 0; d < scan.found.size(); ++d) {
      const TrueDimension& truth = scan.about.dimensions[d];
      if (!scan.found[d] || truth.hidden()) continue;
      out.push_back({truth.truth_cm, scan.found[d]->value_cm, !scan.found[d]->observable});
    }
  }
  return out;
}

std::string agreement_plot(const std::vector<PlotPoint>& points) {
  std::vector<double> truths, both;
  for (const PlotPoint& point : points) {
    truths.push_back(point.truth_cm);
    both.push_back(point.truth_cm), both.push_back(point.estimate_cm);
  }
  const Frame frame{range_showing(truths, {}, 1), range_showing(truths, both, kShownErrors)};
  const double low = std::max(frame.across.low, frame.up.low);
  const double high = std::min(frame.across.high, frame.up.high);
  std::string line;
  if (low < high) {
    line = "<path class=\"level truth\" d=\"M" + coordinate_text(frame.x(low)) + " " +
           coordinate_text(frame.y(low)) + "L" + coordinate_text(frame.x(high)) + " " +
           coordinate_text(frame.y(high)) + "\"/>";
  }
  return axes(frame, "truth, cm", "estimate, cm") + line +
         dots(
             points, frame, [](const PlotPoint& p) { return p.truth_cm; },
             [](const PlotPoint& p) { return p.estimate_cm; });
}

std::string difference_plot(const std::vector<PlotPoint>& points, const ErrorStatistics& errors) {
  std::vector<double> means, differences, always = {0, errors.bias_cm};
  for (const PlotPoint& point : points) {
    means.push_back(0.5 * (point.truth_cm + point.estimate_cm));
    differences.push_back(point.estimate_cm - point.truth_cm);
  }
  const double half = 1.96 * errors.sd_cm.value_or(0);
  if (errors.sd_cm) always.insert(always.end(), {errors.bias_cm - half, errors.bias_cm + half});
  const Frame frame{range_showing({}, means, 1), range_showing(always, differences, kShownErrors)};
  std::string levels = level(frame, 0, "zero") + level(frame, errors.bias_cm, "truth");
  if (errors.sd_cm) {
    levels +=
        level(frame, errors.bias_cm - half, "bound") + level(frame, errors.bias_cm + half, "bound");
  }
  return axes(frame, "mean of truth and estimate, cm", "error, cm") + levels +
         dots(
             points, frame, [](const PlotPoint& p) { return 0.5 * (p.truth_cm + p.estimate_cm); },
             [](const PlotPoint& p) { return p.estimate_cm - p.truth_cm; });
}

}  // namespace regarment
