#include "report/chart.h"

#include <algorithm>
#include <cmath>

#include "report/chart_dots.h"
#include "report/chart_labels.h"
#include "report/svg_path.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr double kLeft = 46.0, kRight = 16.0, kTop = 8.0, kBottom = 20.0;  // margins
constexpr std::size_t kMostDots = 900;
constexpr double kFinestStep = 0.5;  // of a line; finer is not seen

// Where values lie on the drawing.
class Frame {
 public:
  explicit Frame(const Chart& chart) : chart_(chart) {
    for (const ChartRun& run : chart.runs) longest_ = std::max(longest_, run.tried.size());
  }
  double left() const { return kLeft; }
  double right() const { return chart_.width - kRight; }
  double top() const { return kTop; }
  double bottom() const { return chart_.height - kBottom; }
  std::size_t longest() const { return longest_; }

  double x(double evaluation) const {  // from 1 on
    const double last = static_cast<double>(std::max<std::size_t>(longest_, 2) - 1);
    return left() + (evaluation - 1.0) / last * (right() - left());
  }
  double y(double value) const {
    const double share = std::clamp(chart_.range.share(value), 0.0, 1.0);
    return bottom() - share * (bottom() - top());
  }

 private:
  const Chart& chart_;
  std::size_t longest_ = 1;
};

std::string draw_axes(const Chart& chart, const Frame& frame) {
  SvgPath grid;
  std::string words;
  for (const AxisTick& tick : axis_ticks(chart.range, 5)) {
    grid.move_to(frame.left(), frame.y(tick.value));
    grid.horizontal_to(frame.right());
    words += text_element(frame.left() - 6.0, frame.y(tick.value) + 4.0, "y", tick.text);
  }
  const AxisRange evaluations{1.0, static_cast<double>(std::max<std::size_t>(frame.longest(), 2))};
  SvgPath ends;
  ends.move_to(frame.left(), frame.bottom());
  ends.horizontal_to(frame.right());
  for (const AxisTick& tick : axis_ticks(evaluations, 5)) {
    if (tick.value != std::floor(tick.value)) continue;
    ends.move_to(frame.x(tick.value), frame.bottom());
    ends.vertical_to(frame.bottom() + 3.0);
    words += text_element(frame.x(tick.value), frame.bottom() + 15.0, "x",
                          count_text(static_cast<std::size_t>(tick.value)));
  }
  return path_element("grid", grid) + path_element("ends", ends) + words;
}

std::string draw_levels(const Chart& chart, const Frame& frame) {
  std::string out;
  for (const ChartLevel& level : chart.levels) {
    const double share = chart.range.share(level.value);
    if (!(share >= 0.0 && share <= 1.0)) continue;
    SvgPath line;
    line.move_to(frame.left(), frame.y(level.value));
    line.horizontal_to(frame.right());
    out += path_element("level " + level.kind, line);
  }
  return out;
}

std::string draw_dots(const ChartRun& run, std::size_t most, const Frame& frame) {
  SvgPath dots;
  for (const std::size_t i : dots_to_draw(run.tried, most)) {
    dots.dot(frame.x(static_cast<double>(i + 1)), frame.y(run.tried[i]));
  }
  return path_element("dots s" + std::to_string(run.style), dots);
}

struct DrawnLine {
  std::string svg;
  double end_x = 0, end_y = 0;
};

// Level until a better evaluation, then up or down to its value.
DrawnLine draw_line(const ChartRun& run, const Frame& frame) {
  SvgPath steps;
  DrawnLine out;
  bool begun = false;
  for (std::size_t i = 0; i < run.found.size(); ++i) {
    if (std::isnan(run.found[i])) continue;
    const double x = frame.x(static_cast<double>(i + 1)), y = frame.y(run.found[i]);
    if (!begun) {
      steps.move_to(x, y);
    } else if (std::abs(y - out.end_y) >= 0.05 && x - out.end_x >= kFinestStep) {
      steps.horizontal_to(x);
      steps.vertical_to(y);
    } else {
      continue;
    }
    begun = true;
    out.end_x = x;
    out.end_y = y;
  }
  if (!begun) return out;
  out.end_x = frame.x(static_cast<double>(run.found.size()));
  steps.horizontal_to(out.end_x);
  // Close steps were left out; the end is where it is.
  out.end_y = frame.y(run.found.back());
  steps.vertical_to(out.end_y);
  out.svg = path_element("line s" + std::to_string(run.style), steps);
  return out;
}

}  // namespace

std::string draw_chart(const Chart& chart) {
  const Frame frame(chart);
  std::string out = draw_axes(chart, frame), lines, words;
  std::vector<ChartLabel> labels;
  for (const ChartRun& run : chart.runs) {
    out += draw_dots(run, kMostDots / chart.runs.size(), frame);
    const DrawnLine line = draw_line(run, frame);
    if (line.svg.empty()) continue;
    lines += line.svg;
    labels.push_back({line.end_x + 4.0, line.end_y + 4.0, std::to_string(run.number), run.style});
  }
  spread_labels(labels, frame.top() + 8.0, frame.bottom());
  for (const ChartLabel& label : labels) {
    words += text_element(label.x, label.y, "label s" + std::to_string(label.style), label.text);
  }
  return out + draw_levels(chart, frame) + lines + words;
}

}  // namespace regarment
