#include <cmath>

#include "render/heat_map.h"
#include "report/chart_axis.h"
#include "report/page_parts.h"
#include "report/svg_path.h"
#include "report/text.h"

namespace regarment {
namespace {

// The drawing, in its own units: a histogram over the colour bar over its ticks.
constexpr double kWidth = 420, kEdge = 16, kTop = 20, kFloor = 110, kBar = 12, kTickText = 14;
constexpr int kStops = 16;  // of the colour bar; the scale is smooth between them

double x_of(double value_mm, const ResultDeviation& d) {
  return kEdge + (value_mm / d.range_mm + 1.0) / 2.0 * (kWidth - 2 * kEdge);
}

// Attributes one after the other: name, value.
std::string attributes(std::initializer_list<std::pair<const char*, double>> pairs) {
  std::string out;
  for (const auto& [name, value] : pairs) {
    out += std::string(" ") + name + "=\"" + coordinate_text(value) + "\"";
  }
  return out;
}

std::string draw_histogram(const ResultDeviation& d) {
  std::size_t most = 1;
  for (const std::size_t count : d.counts) most = std::max(most, count);
  SvgPath bars;
  const double bin = 2.0 * d.range_mm / static_cast<double>(d.counts.size());
  for (std::size_t i = 0; i < d.counts.size(); ++i) {
    const double from = -d.range_mm + bin * static_cast<double>(i);
    const double height = double(d.counts[i]) / double(most) * (kFloor - kTop);
    bars.move_to(x_of(from, d), kFloor);
    bars.vertical_to(kFloor - height);
    bars.horizontal_to(x_of(from + bin, d));
    bars.vertical_to(kFloor);
  }
  return "<path class=\"bars\" d=\"" + bars.text() + "\"/>";
}

std::string draw_band(const ResultDeviation& d) {
  if (d.band_mm >= d.range_mm) return {};
  return "<rect class=\"band\"" +
         attributes({{"x", x_of(-d.band_mm, d)},
                     {"y", kTop - 4.0},
                     {"width", x_of(d.band_mm, d) - x_of(-d.band_mm, d)},
                     {"height", kFloor - kTop + 4.0}}) +
         "/>";
}

std::string draw_bar(const std::string& id) {
  const ColourScale scale = symmetric_scale(1.0);
  std::string stops;
  for (int i = 0; i <= kStops; ++i) {
    const double share = double(i) / kStops;
    stops += "<stop offset=\"" + significant_text(share, 4) + "\" stop-color=\"" +
             css_colour(scale.colour(2.0 * share - 1.0)) + "\"/>";
  }
  return "<linearGradient id=\"" + id + "\">" + stops +
         "</linearGradient><rect class=\"bar\" fill=\"url(#" + id + ")\"" +
         attributes(
             {{"x", kEdge}, {"y", kFloor}, {"width", kWidth - 2 * kEdge}, {"height", kBar}}) +
         "/>";
}

std::string draw_ticks(const ResultDeviation& d) {
  SvgPath ticks;
  std::string words;
  for (const AxisTick& tick : axis_ticks({-d.range_mm, d.range_mm}, 8)) {
    const double x = x_of(tick.value, d);
    ticks.move_to(x, kFloor + kBar);
    ticks.vertical_to(kFloor + kBar + 3.0);
    const std::string sign = tick.value > 0.0 ? "+" : "";
    words += "<text class=\"x\"" + attributes({{"x", x}, {"y", kFloor + kBar + kTickText}}) + ">" +
             sign + tick.text + "</text>";
  }
  return "<path class=\"ends\" d=\"" + ticks.text() + "\"/>" + words;
}

// An upright line through the histogram, with its name above when it has one.
std::string draw_mark(double value_mm, const ResultDeviation& d, const std::string& kind,
                      const std::string& name) {
  if (std::abs(value_mm) > d.range_mm) return {};
  const double x = x_of(value_mm, d);
  SvgPath line;
  line.move_to(x, kTop - 4.0);
  line.vertical_to(kFloor);
  const std::string text = name.empty()
                               ? ""
                               : "<text class=\"x\"" + attributes({{"x", x}, {"y", kTop - 8.0}}) +
                                     ">" + name + "</text>";
  return "<path class=\"" + kind + "\" d=\"" + line.text() + "\"/>" + text;
}

std::string share_text(std::size_t part, std::size_t whole) {
  return fixed_text(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1);
}

Gaps show_deviation(const ResultGarment& garment, std::size_t number) {
  const ResultDeviation& d = *garment.deviation;
  const std::string id = "deviation-" + std::to_string(number);
  Gaps gaps;
  gaps.set("id", id);
  gaps.set("name", garment.title);
  gaps.set("median", signed_text(d.median_mm, 1));
  gaps.set("p95", fixed_text(d.p95_mm, 1));
  gaps.set("vertices", count_text(d.vertices));
  gaps.set("within", share_text(d.within, d.vertices));
  gaps.set("band", short_text(d.band_mm));
  gaps.set("band_is_drawn", d.band_mm < d.range_mm);
  gaps.set("no_data", css_colour(no_data_colour()));
  gaps.set("range", significant_text(d.range_mm, 1));
  gaps.set_maybe("beyond", d.below + d.above == 0 ? "" : share_text(d.below + d.above, d.vertices));
  gaps.set("drawing", draw_band(d) + draw_bar(id + "-colours") + draw_histogram(d) +
                          draw_mark(-d.p95_mm, d, "p95", "") + draw_mark(d.p95_mm, d, "p95", "") +
                          draw_mark(d.median_mm, d, "median", "median") + draw_ticks(d));
  return gaps;
}

}  // namespace

std::vector<Gaps> show_deviations(const Result& result) {
  std::vector<Gaps> out;
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    if (result.garments[i].deviation) out.push_back(show_deviation(result.garments[i], i + 1));
  }
  return out;
}

}  // namespace regarment
