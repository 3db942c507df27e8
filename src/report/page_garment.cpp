#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "garment/pattern_svg.h"
#include "report/judgement.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr double kCentimetre = 0.01;  // m

std::string cm(double value_cm) { return cm_text(value_cm * kCentimetre); }
std::string cm(const std::optional<double>& value_cm) { return value_cm ? cm(*value_cm) : ""; }

// The little interval drawings share one scale: half of their width, cm.
double half_scale(const ResultGarment& garment) {
  double half = 0.5;
  for (const ResultMeasurement& m : garment.measurements) {
    if (!m.observable) continue;
    half = std::max({half, m.value_cm - m.low_cm, m.high_cm - m.value_cm});
    if (const auto error = m.error_cm()) half = std::max(half, std::min(std::abs(*error), 5.0));
  }
  return half;
}

constexpr double kPlotMiddle = 48.0;  // px, and half of what the drawing may take
constexpr double kPlotReach = 42.0;

std::string plot_x(double offset_cm, double half) {
  return fixed_text(kPlotMiddle + kPlotReach * std::clamp(offset_cm / half, -1.05, 1.05), 1);
}

void show_interval(const ResultMeasurement& m, double half, Gaps& row) {
  row.set("low", cm(m.low_cm));
  row.set("high", cm(m.high_cm));
  row.set("low_x", plot_x(m.low_cm - m.value_cm, half));
  row.set("high_x", plot_x(m.high_cm - m.value_cm, half));
  row.set("has_truth_x", m.truth_cm.has_value());
  if (!m.truth_cm) return;
  const double truth = *m.truth_cm - m.value_cm;
  const Tolerance tolerance = tolerance_of(m);
  row.set("truth_x", plot_x(truth, half));
  row.set("band_from_x", plot_x(truth - tolerance.minus_cm, half));
  row.set("band_to_x", plot_x(truth + tolerance.plus_cm, half));
}

struct Verdict {
  const char *css, *icon, *text;
};

// In the order of Judgement.
constexpr std::array<Verdict, 6> kVerdicts = {{{"pass", "\u2713", "pass"},
                                               {"pass", "\u2713", "pass, likely"},
                                               {"fail", "\u2717", "fail, likely"},
                                               {"fail", "\u2717", "fail"},
                                               {"none", "\u2013", "not measurable"},
                                               {"none", "\u2013", "not judged"}}};

// A value and, of a circumference, its half, as tech packs have it.
void show_length(const std::string& name, const std::optional<double>& value_cm, bool circumference,
                 Gaps& row) {
  row.set_maybe(name, cm(value_cm));
  row.set_maybe("half_" + name, value_cm && circumference ? cm(*value_cm / 2.0) : "");
}

void show_judgement(const ResultMeasurement& m, Gaps& row) {
  const Tolerance tolerance = tolerance_of(m);
  const bool judged = m.truth_cm.has_value() || tolerance.given;
  row.set_maybe("tol_minus", judged ? "\u2212" + cm(tolerance.minus_cm) : "");
  row.set_maybe("tol_plus", judged ? "+" + cm(tolerance.plus_cm) : "");
  row.set("usual", judged && !tolerance.given);
  const auto error = m.error_cm();
  row.set_maybe("error", error && m.observable ? signed_cm_text(*error * kCentimetre) : "");
  const Verdict& verdict = kVerdicts[static_cast<std::size_t>(judge(m))];
  row.set("result_kind", verdict.css);
  row.set("result_icon", verdict.icon);
  row.set("result", verdict.text);
}

/// "83.4 if the waist lies elsewhere (weight 0.28)"; empty where there is one answer.
std::string rivals_in_words(const ResultMeasurement& m) {
  std::string text;
  for (const ResultRivalLength& rival : m.rivals) {
    std::string edges;
    for (const std::string& edge : rival.edges) edges += (edges.empty() ? "" : " and ") + edge;
    std::replace(edges.begin(), edges.end(), '_', ' ');
    text += text.empty() ? "" : ", ";
    text += cm(rival.value_cm) + " if the " + edges + (rival.edges.size() > 1 ? " lie" : " lies") +
            " elsewhere (weight " + fixed_text(rival.weight, 2) + ")";
  }
  return text;
}

Gaps show_measurement(const ResultGarment& garment, std::size_t index, double half) {
  const ResultMeasurement& m = garment.measurements[index];
  Gaps row;
  row.set("letter", dimension_letter(index));
  row.set("id", garment.template_name + "-" + std::to_string(garment.layer) + "-" + m.code);
  row.set("code", m.code);
  row.set("title", m.title);
  row.set("how", m.how_to_measure);
  row.set("definition", m.definition);
  show_length("value", m.value_cm, m.circumference, row);
  show_length("worn", m.worn_cm, m.circumference, row);
  show_length("spec", m.truth_cm, m.circumference, row);
  row.set_maybe("published", cm(m.published_cm));
  row.set_maybe("rivals", rivals_in_words(m));
  row.set("observable", m.observable);
  row.set("hidden", !m.observable);
  row.set("fixed", m.fixed);
  show_interval(m, half, row);
  show_judgement(m, row);
  return row;
}

/// "4.2 cm higher"
std::string beside(double offset_cm) {
  return cm(std::abs(offset_cm)) + "\u202fcm " + (offset_cm < 0 ? "lower" : "higher");
}

/// Where else the edge may lie, and how a person settles it. Of no edge with one answer.
std::string rivals_in_words(const ResultGarment& garment, const ResultEdge& edge) {
  std::string text;
  for (const ResultRival& rival : edge.rivals) {
    text += text.empty() ? "may as well lie " : ", or ";
    text +=
        beside(rival.height_cm - edge.height_cm) + " (weight " + fixed_text(rival.weight, 2) + ")";
  }
  if (text.empty()) return text;
  return text + "; if so, give --hint " + garment.template_name + "." + edge.name +
         "_edge=" + cm(edge.rivals.front().height_cm);
}

Gaps show_edge(const ResultGarment& garment, const ResultEdge& edge) {
  Gaps row;
  std::string name = edge.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  row.set("name", name);
  row.set("evidence", edge.evidence);
  row.set("standard_error", fixed_text(edge.standard_error_mm, 1));
  row.set("coverage", fixed_text(std::floor(edge.coverage * 100.0), 0));
  row.set("length", cm(edge.length_cm));
  row.set("height", cm(edge.height_cm));
  row.set_maybe("flat", cm(edge.flat_cm));
  row.set_maybe("beside", cm(edge.beside_cm));
  const auto ease = edge.ease_cm();
  row.set_maybe("ease", ease ? signed_cm_text(*ease * kCentimetre) : "");
  row.set_maybe("rivals", rivals_in_words(garment, edge));
  return row;
}

/// Each edge that has a left and a right: how the two differ.
std::vector<Gaps> show_sides(const ResultGarment& garment) {
  std::vector<Gaps> out;
  for (const ResultEdge& left : garment.edges) {
    if (!left.name.starts_with("left_")) continue;
    const std::string what = left.name.substr(5);
    for (const ResultEdge& right : garment.edges) {
      if (right.name != "right_" + what) continue;
      Gaps& gaps = out.emplace_back();
      gaps.set("what", what);
      gaps.set("left", cm(left.length_cm));
      gaps.set("right", cm(right.length_cm));
      gaps.set("difference", signed_cm_text((left.length_cm - right.length_cm) * kCentimetre));
      gaps.set("height", left.height_cm < right.height_cm ? "lower" : "higher");
      gaps.set("apart", cm(std::abs(left.height_cm - right.height_cm)));
    }
  }
  return out;
}

bool any(const ResultGarment& garment, bool (*has)(const ResultMeasurement&)) {
  return std::any_of(garment.measurements.begin(), garment.measurements.end(), has);
}

// As a picture the drawing keeps its styles and its text to itself, and can neither run nor fetch.
std::string picture_of(const std::string& svg) {
  if (!svg.starts_with("<svg") && !svg.starts_with("<?xml")) {
    throw ReadError("a sketch is no SVG; run 'regarment fit' again");
  }
  return "data:image/svg+xml;base64," + base64(svg);
}

std::string in_words(const ResultGarment& garment) {
  std::string text = "Flat sketch of the " + garment.title + " with its measurements";
  for (std::size_t i = 0; i < garment.measurements.size(); ++i) {
    const ResultMeasurement& m = garment.measurements[i];
    text += ", " + dimension_letter(i) + " " + m.title + " " + cm(m.value_cm) + " cm";
  }
  return text;
}

}  // namespace

Gaps show_garment(const ResultGarment& garment, std::size_t number, const std::string& sketch) {
  Gaps gaps;
  gaps.set("number", std::to_string(number));
  gaps.set("name", garment.title);
  gaps.set("template", garment.template_name);
  gaps.set("layer", std::to_string(garment.layer));
  const double half = half_scale(garment);
  std::vector<Gaps> rows;
  for (std::size_t i = 0; i < garment.measurements.size(); ++i) {
    rows.push_back(show_measurement(garment, i, half));
  }
  const bool with_spec = any(garment, [](const auto& m) { return m.truth_cm.has_value(); });
  gaps.set("measurements", std::move(rows));
  gaps.set("with_spec", with_spec);
  gaps.set("with_published",
           any(garment, [](const auto& m) { return m.published_cm.has_value(); }));
  gaps.set("with_usual", with_spec && any(garment, [](const auto& m) {
                           return m.truth_cm.has_value() && !tolerance_of(m).given;
                         }));
  gaps.set("usual_length", cm(kUsualLength));
  gaps.set("usual_girth", cm(kUsualGirth));
  gaps.set("with_hidden", any(garment, [](const auto& m) { return !m.observable; }));
  std::vector<Gaps> edges;
  for (const ResultEdge& edge : garment.edges) edges.push_back(show_edge(garment, edge));
  gaps.set("has_edges", !edges.empty());
  gaps.set("edges", std::move(edges));
  gaps.set("sides", show_sides(garment));
  gaps.set("distance", fixed_text(garment.mean_distance_m * 1000.0, 1));
  gaps.set("stretched", garment.mean_stretch < 1.0 ? "compressed" : "stretched");
  gaps.set("stretch", fixed_text(std::abs(garment.mean_stretch - 1.0) * 100.0, 1));
  gaps.set_maybe("silhouette", garment.silhouette ? fixed_text(*garment.silhouette, 2) : "");
  gaps.set("drawing", picture_of(sketch));
  gaps.set("drawing_in_words", in_words(garment));
  return gaps;
}

}  // namespace regarment
