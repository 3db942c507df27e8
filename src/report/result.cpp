#include "report/result.h"

#include <algorithm>
#include <cmath>

#include "analysis/beside_edge.h"
#include "base/error.h"
#include "base/one_line.h"
#include "report/text.h"
#include "report/version.h"

namespace regarment {
namespace {

constexpr int kDigits = 4;  // of a centimetre or millimetre; more is noise

double finite(double value, const char* what) {
  if (!std::isfinite(value)) throw InvalidInput(std::string(what) + " is not a finite number");
  return rounded(value, kDigits);
}

double cm(double metres) { return finite(metres * 100.0, "a length"); }

std::optional<double> cm(const std::optional<double>& metres) {
  if (!metres) return std::nullopt;
  return cm(*metres);
}

double loop_length(const std::vector<Vec3>& points) {
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    length += (points[(i + 1) % points.size()] - points[i]).norm();
  }
  return length;
}

double mean_height(const std::vector<Vec3>& points) {
  double sum = 0.0;
  for (const Vec3& point : points) sum += point.y();
  return points.empty() ? 0.0 : sum / static_cast<double>(points.size());
}

ResultMeasurement result_measurement(const Measurement& m, const GarmentTemplate& garment) {
  ResultMeasurement out;
  out.name = m.name;
  out.code = m.code;
  out.title = m.name;
  for (const Dimension& dimension : garment.dimensions()) {
    if (dimension.name != m.name) continue;
    out.title = dimension.title;
    out.definition = dimension.definition;
    out.how_to_measure = dimension.how_to_measure;
    out.circumference = dimension.circumference;
  }
  out.value_cm = cm(m.flat);
  out.low_cm = cm(m.low);
  out.high_cm = cm(m.high);
  out.worn_cm = cm(m.worn);
  if (m.sources) {
    out.worn_fit_cm = cm(m.sources->fit);
    out.worn_line_cm = cm(m.sources->line);
    out.worn_scan_cm = cm(m.sources->scan);
  }
  for (const RivalLength& rival : m.rivals)
    out.rivals.push_back({rival.edges, cm(rival.flat), finite(rival.weight, "a weight")});
  out.observable = m.observable;
  out.fixed = m.fixed;
  out.truth_cm = cm(m.truth);
  out.published_cm = cm(m.published);
  out.tol_minus_cm = cm(m.tol_minus);
  out.tol_plus_cm = cm(m.tol_plus);
  return out;
}

/// Of an edge whose girth the template states by dimensions that were seen; others are not
/// measured.
std::optional<double> flat_length(const GarmentAnalysis& garment, const GarmentTemplate& of,
                                  const std::string& edge) {
  for (const Observation& girth : of.observations()) {
    if (girth.kind != Observation::Kind::Girth || girth.edge != edge) continue;
    const bool seen = std::all_of(
        garment.measurements.begin(), garment.measurements.end(), [&](const Measurement& m) {
          return m.observable || !of.gives(girth.equals, m.name, garment.dimensions);
        });
    if (seen) return of.evaluate(girth.equals, garment.dimensions);
  }
  return std::nullopt;
}

ResultEdge result_edge(const Analysis& analysis, const GarmentAnalysis& garment,
                       const GarmentTemplate& of, const EdgeCurve& edge) {
  ResultEdge out;
  out.name = edge.name;
  out.evidence = edge.evidence;
  out.standard_error_mm = finite(edge.standard_error * 1000.0, "a standard error");
  out.coverage = finite(edge.coverage, "a coverage");
  out.length_cm = cm(loop_length(edge.points));
  out.height_cm = cm(mean_height(edge.points));
  for (const EdgeRival& rival : edge.rivals)
    out.rivals.push_back({cm(rival.height), finite(rival.weight, "a weight")});
  out.flat_cm = cm(flat_length(garment, of, edge.name));
  out.beside_cm = cm(girth_beside(analysis, garment, edge));
  return out;
}

// `range`: of the colours, m, one for all garments.
ResultGarment result_garment(const Analysis& analysis, const GarmentAnalysis& garment,
                             const GarmentTemplate& of, double range) {
  ResultGarment out;
  out.template_name = garment.template_name;
  out.title = of.title();
  out.layer = garment.layer;
  for (const Measurement& m : garment.measurements) {
    out.measurements.push_back(result_measurement(m, of));
  }
  for (const EdgeCurve& edge : garment.edges)
    out.edges.push_back(result_edge(analysis, garment, of, edge));
  for (const SideDifference& d : garment.asymmetry)
    out.asymmetry.push_back({d.dimension, d.sides == Sides::LeftRight ? "left_right" : "front_back",
                             cm(d.difference), cm(d.spread)});
  out.mean_distance_m = rounded(finite(garment.mean_distance * 1e4, "a distance") / 1e4, 7);
  out.mean_stretch = finite(garment.mean_stretch, "a stretch");
  if (garment.silhouette) out.silhouette = finite(*garment.silhouette, "a silhouette error");
  if (garment.trace) {
    out.search = make_search(garment, of);
    out.mean_distance_m = out.search->terms.distance;
    out.mean_stretch = out.search->terms.stretch;
  }
  out.deviation = summarize_deviation(garment.deviation, range);
  out.vertices_labelled = garment.vertices_labelled;
  return out;
}

ResultScan result_scan(const Analysis& analysis, const ReportOptions& options) {
  const ScanFacts& facts = analysis.scan.facts;
  ResultScan out;
  out.file = one_line(facts.file, 300);
  out.sha256 = facts.sha256;
  out.units = facts.units;
  out.up = facts.up;
  out.front = facts.front;
  out.units_guessed = facts.units_guessed;
  out.up_guessed = facts.up_guessed;
  out.front_guessed = facts.front_guessed;
  out.front_confidence = finite(facts.front_confidence, "the front's confidence");
  out.noise_mm = finite(facts.noise * 1000.0, "the noise");
  out.spacing_mm = finite(facts.spacing * 1000.0, "the spacing");
  out.height_cm = cm(facts.height);
  out.vertices = analysis.scan.mesh.positions.size();
  out.triangles = analysis.scan.mesh.triangles.size();
  out.caps = static_cast<std::size_t>(std::count(analysis.cap.begin(), analysis.cap.end(), 1));
  out.outliers = facts.outliers;
  out.holes = facts.holes;
  for (const Finding& f : facts.findings) {
    out.findings.push_back({f.code, f.severity, one_line(f.found, 600), one_line(f.done, 600),
                            one_line(f.advice, 600)});
  }
  if (options.timing) out.path = one_line(options.scan_path, 4096);
  return out;
}

void count_labels(const Analysis& analysis, Result& out) {
  out.garment_counts.assign(analysis.garments.size(), 0);
  for (const std::uint8_t label : analysis.labels) {
    if (label == 0) {
      ++out.person;
    } else if (label <= out.garment_counts.size()) {
      ++out.garment_counts[label - 1u];
    } else {
      throw InvalidInput("a label names garment " + std::to_string(label) + ", which is not there");
    }
  }
  for (const float probability : analysis.label_probability) {
    if (probability < kUnsureBelow) ++out.unsure;
  }
}

std::string command_line(const Result& result, const ReportOptions& options) {
  std::string line = "regarment fit " + shell_quoted(result.scan.path.value_or(result.scan.file));
  for (const ResultGarment& garment : result.garments) {
    line += " --garment " + shell_quoted(garment.template_name);
  }
  line += " --method " + shell_quoted(result.method) + " --seed " + std::to_string(result.seed);
  for (const auto& [name, value] : options.options) {
    line += " --" + name;
    if (!value.empty()) line += " " + shell_quoted(one_line(value, 4096));
  }
  return line + " --out DIR";
}

void check_sizes(const Analysis& analysis, const std::vector<GarmentTemplate>& templates) {
  const std::size_t n = analysis.scan.mesh.positions.size();
  if (analysis.labels.size() != n || analysis.label_probability.size() != n) {
    throw InvalidInput("labels and probabilities must have one entry per vertex of the scan");
  }
  if (!analysis.cap.empty() && analysis.cap.size() != analysis.scan.mesh.triangles.size()) {
    throw InvalidInput("caps must have one entry per triangle of the scan");
  }
  if (templates.size() != analysis.garments.size()) {
    throw InvalidInput("one template per garment is needed");
  }
}

void add_times(const Analysis& analysis, Result& out) {
  double total = 0.0;
  for (const StageTime& time : analysis.times) {
    out.timing_s.emplace_back(time.stage, finite(time.seconds, "a time"));
    total += time.seconds;
  }
  out.timing_s.emplace_back("total", finite(total, "a time"));
}

void add_warnings(const std::vector<std::string>& warnings, Result& out) {
  for (const std::string& warning : warnings) {
    const std::string line = one_line(warning, 600);
    if (std::find(out.warnings.begin(), out.warnings.end(), line) == out.warnings.end()) {
      out.warnings.push_back(line);
    }
  }
}

}  // namespace

std::optional<double> ResultMeasurement::error_cm() const {
  if (!truth_cm) return std::nullopt;
  return rounded(value_cm - *truth_cm, kDigits);
}

std::optional<double> ResultEdge::ease_cm() const {
  if (!flat_cm || !beside_cm) return std::nullopt;
  return rounded(*flat_cm - *beside_cm, kDigits);
}

Result make_result(const Analysis& analysis, const std::vector<GarmentTemplate>& templates,
                   const ReportOptions& options) {
  check_sizes(analysis, templates);
  Result out;
  out.version = version();
  out.method = analysis.method;
  out.fabric = fabric_name(analysis.fabric);
  out.seed = options.seed;
  out.refit = options.refit;
  out.options = options.options;
  out.settings = options.settings;
  for (auto* list : {&out.options, &out.settings})
    for (auto& [name, value] : *list) value = one_line(value, 4096);
  out.scan = result_scan(analysis, options);
  const double range = deviation_range(merged_deviation(analysis));
  for (std::size_t i = 0; i < analysis.garments.size(); ++i) {
    out.garments.push_back(result_garment(analysis, analysis.garments[i], templates[i], range));
  }
  out.command = command_line(out, options);
  count_labels(analysis, out);
  out.label_score = options.label_score;
  for (const auto& [name, height] : analysis.landmarks) {
    out.landmarks_cm.emplace_back(name, cm(height));
  }
  add_warnings(analysis.warnings, out);
  if (options.timing) {
    out.threads = options.threads;
    add_times(analysis, out);
  }
  return out;
}

}  // namespace regarment
