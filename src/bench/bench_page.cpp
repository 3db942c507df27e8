#include <algorithm>

#include "bench/bench.h"
#include "report/chart_axis.h"
#include "report/content_policy.h"
#include "report/embedded.h"
#include "report/gaps.h"
#include "report/svg_path.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr double kWidth = 420, kHeight = 260, kLeft = 52, kRight = 12, kTop = 22, kBottom = 40;

// All of the values, which are positive, and a little room.
AxisRange logarithmic(const std::vector<double>& values) {
  constexpr double kRoom = 1.15;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low / kRoom, *high * kRoom, true};
}

// Time over size, both logarithmic, so that the slope is the exponent.
std::string plot(const GrowthCurve& curve) {
  std::vector<double> sizes, times;
  for (const GrowthCurve::Point& p : curve.points)
    sizes.push_back(p.size), times.push_back(1e3 * p.seconds);
  const AxisRange across = logarithmic(sizes), up = logarithmic(times);
  const auto x = [&](double v) { return kLeft + across.share(v) * (kWidth - kLeft - kRight); };
  const auto y = [&](double v) {
    return kHeight - kBottom - up.share(v) * (kHeight - kTop - kBottom);
  };
  SvgPath grid, ends, dots;
  std::string words, corners;
  for (const AxisTick& tick : axis_ticks(up, 5)) {
    grid.move_to(kLeft, y(tick.value));
    grid.horizontal_to(kWidth - kRight);
    words += text_element(kLeft - 6, y(tick.value) + 4, "y", tick.text);
  }
  ends.move_to(kLeft, kHeight - kBottom);
  ends.horizontal_to(kWidth - kRight);
  for (const AxisTick& tick : axis_ticks(across, 4)) {
    ends.move_to(x(tick.value), kHeight - kBottom);
    ends.vertical_to(kHeight - kBottom + 4);
    words += text_element(x(tick.value), kHeight - kBottom + 17, "x", tick.text);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    corners += coordinate_text(x(sizes[i])) + "," + coordinate_text(y(times[i])) + " ";
    dots.dot(x(sizes[i]), y(times[i]));
  }
  words += text_element(0.5 * (kLeft + kWidth - kRight), kHeight - 6, "x", curve.size_unit);
  words += text_element(0, kTop - 8, "name", "ms");
  return path_element("grid", grid) + path_element("ends", ends) + words +
         "<polyline class=\"line s0\" points=\"" + corners + "\"/>" + path_element("dots s0", dots);
}

Gaps row_gaps(const BenchRow& row) {
  const auto figure = [&](const std::optional<double>& value) {
    return value ? significant_text(*value, 3) + "\u00a0" + row.unit : std::string();
  };
  Gaps gaps;
  gaps.set("group", row.group);
  gaps.set("name", row.name);
  gaps.set("value", figure(row.value));
  gaps.set_maybe("other", row.other_value ? row.other + " " + figure(row.other_value) : "");
  const auto ratio = row.ratio();
  gaps.set_maybe("ratio", ratio ? significant_text(*ratio, 2) + "\u00a0×" : "");
  std::string aim;
  if (row.at_most) aim = "at most " + significant_text(*row.at_most, 3);
  if (row.at_least) aim = "at least " + significant_text(*row.at_least, 3);
  if (!aim.empty()) aim += row.by_ratio ? "\u00a0×" : "\u00a0" + row.unit;
  gaps.set_maybe("aim", aim);
  const auto reached = row.reached();
  gaps.set("reached", reached.value_or(false));
  gaps.set("missed", reached.has_value() && !*reached);
  return gaps;
}

Gaps curve_gaps(const GrowthCurve& curve, std::size_t number) {
  Gaps gaps;
  gaps.set("number", std::to_string(number));
  gaps.set("name", curve.name);
  gaps.set("exponent", fixed_text(curve.exponent, 2));
  gaps.set("plot", plot(curve));
  std::string words;
  for (const GrowthCurve::Point& p : curve.points)
    words += significant_text(p.size, 3) + " " + curve.size_unit + ": " +
             significant_text(1e3 * p.seconds, 3) + " ms. ";
  gaps.set("words", words);
  return gaps;
}

}  // namespace

std::string bench_page(const Bench& bench) {
  Gaps page;
  page.set("version", bench.version);
  page.set("scan", bench.scan);
  std::vector<Gaps> rows, curves;
  for (const BenchRow& row : bench.rows) rows.push_back(row_gaps(row));
  for (const GrowthCurve& curve : bench.curves)
    if (curve.points.size() > 1) curves.push_back(curve_gaps(curve, curves.size() + 1));
  page.set("rows", std::move(rows));
  page.set("curves", std::move(curves));
  page.set("plot_width", coordinate_text(kWidth));
  page.set("plot_height", coordinate_text(kHeight));
  std::string style;
  for (const char* name :
       {"report.css", "report_pictures.css", "report_media.css", "evaluation.css"})
    style += embedded_text(name);
  page.set("style", style);
  page.set("policy", content_policy(style, ""));
  return fill_template(embedded_text("bench.html"), page);
}

}  // namespace regarment
