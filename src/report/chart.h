#pragma once

#include <string>
#include <vector>

#include "report/chart_axis.h"

namespace regarment {

/// One run in a chart. Both vectors have one entry per evaluation; NaN shows nothing.
struct ChartRun {
  std::vector<double> tried;  // drawn as dots
  std::vector<double> found;  // at the best evaluation so far, drawn as a line of steps
  std::size_t number = 1;     // written at the end of the line
  int style = 0;              // 0: the one to look at; 1..5 are told apart by dashes and colour
};

/// A level across the chart.
struct ChartLevel {
  double value = 0;
  std::string kind;  // CSS class: "truth", "bound"
};

/// A value over the evaluations of some runs.
struct Chart {
  int width = 300, height = 170;  // of the drawing's own units, about a pixel each
  AxisRange range;                // values beyond it are drawn on the edge
  std::vector<ChartRun> runs;     // drawn in this order, so the last lies on top
  std::vector<ChartLevel> levels;
};

/// The inside of an SVG element with viewBox "0 0 width height": lines, dots and numbers only, in
/// the classes grid, ends, dots, line, label and sN of report.css. At most some 900 dots and 500
/// steps a line are drawn, so that long searches stay small; of dots that lie close the extremes
/// are kept.
std::string draw_chart(const Chart& chart);

}  // namespace regarment
