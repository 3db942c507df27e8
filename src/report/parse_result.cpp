#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/json_schema.h"
#include "report/result.h"

namespace regarment {
namespace {

// Keeps the order of the file.
using Json = nlohmann::ordered_json;

std::optional<double> optional_number(const Json& object, const char* key) {
  if (!object.contains(key) || object[key].is_null()) return std::nullopt;
  return object[key].get<double>();
}

std::vector<std::pair<std::string, double>> number_pairs(const Json& object) {
  std::vector<std::pair<std::string, double>> out;
  for (const auto& [name, value] : object.items()) out.emplace_back(name, value.get<double>());
  return out;
}

ResultMeasurement read_measurement(const Json& j) {
  ResultMeasurement m;
  j.at("name").get_to(m.name);
  j.at("code").get_to(m.code);
  j.at("title").get_to(m.title);
  j.at("definition").get_to(m.definition);
  j.at("how_to_measure").get_to(m.how_to_measure);
  j.at("circumference").get_to(m.circumference);
  j.at("value_cm").get_to(m.value_cm);
  j.at("interval_cm").at(0).get_to(m.low_cm);
  j.at("interval_cm").at(1).get_to(m.high_cm);
  j.at("observable").get_to(m.observable);
  j.at("fixed").get_to(m.fixed);
  m.worn_cm = optional_number(j, "worn_cm");
  m.worn_fit_cm = optional_number(j, "worn_fit_cm");
  m.worn_line_cm = optional_number(j, "worn_line_cm");
  m.worn_scan_cm = optional_number(j, "worn_scan_cm");
  for (const Json& r : j.value("rivals", Json::array()))
    m.rivals.push_back({r.at("edges"), r.at("value_cm"), r.at("weight")});
  m.truth_cm = optional_number(j, "truth_cm");
  m.published_cm = optional_number(j, "published_cm");
  m.tol_minus_cm = optional_number(j, "tol_minus_cm");
  m.tol_plus_cm = optional_number(j, "tol_plus_cm");
  return m;
}

// `where` says which garment, for messages about what the schema cannot hold.
[[noreturn]] void contradiction(const std::string& where, const std::string& what) {
  throw ReadError(where + what + "; make the result again with 'regarment fit'");
}

ResultRun read_run(const Json& j, const ResultSearch& search, const std::string& where) {
  ResultRun run;
  j.at("seed").get_to(run.seed);
  run.ending = j.at("ending") == "converged" ? FitEnding::Converged : FitEnding::EvaluationLimit;
  j.at("evaluations").get_to(run.evaluations);
  j.at("unsettled").get_to(run.unsettled);
  j.at("best_evaluation").get_to(run.best);
  j.at("error").get_to(run.error);
  const Json& lengths = j.at("dimensions_cm");
  for (const SearchedDimension& d : search.dimensions) {
    if (!lengths.contains(d.name)) contradiction(where, "/runs: no value of '" + d.name + "'");
    run.dimensions_cm.push_back(lengths[d.name].get<double>());
  }
  if (lengths.size() != search.dimensions.size()) {
    contradiction(where, "/runs: a dimension that was not searched");
  }
  if (run.best > run.evaluations || run.unsettled > run.evaluations) {
    contradiction(where, "/runs: an evaluation that was not made");
  }
  return run;
}

ResultSearch read_search(const Json& garment, const std::string& where) {
  const Json &j = garment.at("search"), &error = garment.at("error");
  ResultSearch s;
  const Json& weights = j.at("weights");
  s.weights = {weights.at("alpha"), weights.at("beta"), weights.at("gamma")};
  j.at("square_root").get_to(s.square_root);
  j.at("kept_run").get_to(s.kept);
  for (const Json& d : j.at("dimensions")) {
    s.dimensions.push_back({d.at("name"), d.at("lower_cm"), d.at("upper_cm")});
  }
  for (const Json& run : garment.at("runs")) s.runs.push_back(read_run(run, s, where));
  if (s.kept > s.runs.size()) contradiction(where, "/search: the kept run is not among the runs");
  const auto total = optional_number(error, "total");
  const auto silhouette = optional_number(error, "silhouette");
  if (!total || !silhouette) contradiction(where, "/error: a search has a total and a silhouette");
  s.total = *total;
  s.terms = {error.at("distance_m"), error.at("stretch"), *silhouette};
  return s;
}

ResultDeviation read_deviation(const Json& j, const std::string& where) {
  ResultDeviation d;
  j.at("vertices").get_to(d.vertices);
  j.at("median_mm").get_to(d.median_mm);
  j.at("p95_mm").get_to(d.p95_mm);
  j.at("band_mm").get_to(d.band_mm);
  j.at("within_band").get_to(d.within);
  j.at("range_mm").get_to(d.range_mm);
  const Json& histogram = j.at("histogram");
  histogram.at("below").get_to(d.below);
  histogram.at("above").get_to(d.above);
  histogram.at("counts").get_to(d.counts);
  std::size_t sum = d.below + d.above;
  for (const std::size_t count : d.counts) sum += count;
  if (d.within > d.vertices)
    contradiction(where, "/deviation: more within the band than there are");
  if (sum != d.vertices) contradiction(where, "/deviation: the counts do not add up");
  return d;
}

ResultEdge read_edge(const Json& j) {
  ResultEdge e{j.at("name"),     j.at("evidence"),  j.at("standard_error_mm"),
               j.at("coverage"), j.at("length_cm"), j.at("height_cm")};
  for (const Json& r : j.at("rivals")) e.rivals.push_back({r.at("height_cm"), r.at("weight")});
  e.flat_cm = optional_number(j, "flat_cm");
  e.beside_cm = optional_number(j, "beside_cm");
  return e;
}

ResultGarment read_garment(const Json& j, const std::string& where) {
  ResultGarment g;
  j.at("template").get_to(g.template_name);
  j.at("title").get_to(g.title);
  j.at("layer").get_to(g.layer);
  j.at("error").at("distance_m").get_to(g.mean_distance_m);
  j.at("error").at("stretch").get_to(g.mean_stretch);
  j.at("vertices_labelled").get_to(g.vertices_labelled);
  for (const Json& m : j.at("measurements")) g.measurements.push_back(read_measurement(m));
  for (const Json& e : j.at("edges")) g.edges.push_back(read_edge(e));
  for (const Json& a : j.value("asymmetry", Json::array()))
    g.asymmetry.push_back({a.at("name"), a.at("sides"), a.at("difference_cm"), a.at("spread_cm")});
  if (j.contains("search") != !j.at("runs").empty()) {
    contradiction(where, ": has a search without runs, or runs without a search");
  }
  if (j.contains("search"))
    g.search = read_search(j, where);
  else
    g.silhouette = optional_number(j.at("error"), "silhouette");
  if (j.contains("deviation")) g.deviation = read_deviation(j.at("deviation"), where);
  return g;
}

ResultScan read_scan(const Json& j) {
  ResultScan s;
  j.at("file").get_to(s.file);
  j.at("sha256").get_to(s.sha256);
  j.at("units").get_to(s.units);
  j.at("up").get_to(s.up);
  j.at("front").get_to(s.front);
  j.at("units_guessed").get_to(s.units_guessed);
  j.at("up_guessed").get_to(s.up_guessed);
  j.at("front_guessed").get_to(s.front_guessed);
  j.at("front_confidence").get_to(s.front_confidence);
  j.at("height_cm").get_to(s.height_cm);
  j.at("spacing_mm").get_to(s.spacing_mm);
  j.at("noise_mm").get_to(s.noise_mm);
  j.at("vertices").get_to(s.vertices);
  j.at("triangles").get_to(s.triangles);
  j.at("caps").get_to(s.caps);
  j.at("outliers").get_to(s.outliers);
  j.at("holes").get_to(s.holes);
  for (const Json& f : j.at("findings")) {
    s.findings.push_back({f.at("code"), severity_named(f.at("severity").get<std::string>()),
                          f.at("found"), f.at("done"), f.at("advice")});
  }
  if (j.contains("path")) s.path = j.at("path").get<std::string>();
  return s;
}

void read_program(const Json& j, Result& r) {
  j.at("version").get_to(r.version);
  j.at("method").get_to(r.method);
  j.at("command").get_to(r.command);
  j.at("seed").get_to(r.seed);
  for (const auto& [name, value] : j.at("options").items()) r.options.emplace_back(name, value);
  if (j.contains("settings"))
    for (const auto& [name, value] : j.at("settings").items()) r.settings.emplace_back(name, value);
  r.refit = j.value("refit", false);
  if (j.contains("threads")) r.threads = j.at("threads").get<int>();
}

void read_segmentation(const Json& j, Result& r) {
  j.at("person").get_to(r.person);
  j.at("garments").get_to(r.garment_counts);
  j.at("unsure").get_to(r.unsure);
  if (!j.contains("truth")) return;
  const Json& truth = j.at("truth");
  LabelScore score{truth.at("scored"), truth.at("accuracy"), truth.at("mean_iou"), {}};
  for (const Json& iou : truth.at("iou")) {
    score.iou.push_back(iou.is_null() ? std::nullopt : std::optional<double>(iou.get<double>()));
  }
  r.label_score = std::move(score);
}

}  // namespace

Result parse_result(const std::string& text, const std::string& name) {
  check_by_result_schema(text, name);
  const Json j = Json::parse(text);
  Result r;
  read_program(j.at("program"), r);
  j.at("fabric").get_to(r.fabric);
  r.scan = read_scan(j.at("scan"));
  for (const Json& g : j.at("garments")) {
    r.garments.push_back(
        read_garment(g, name + ": at /garments/" + std::to_string(r.garments.size())));
  }
  read_segmentation(j.at("segmentation"), r);
  r.landmarks_cm = number_pairs(j.at("landmarks_cm"));
  j.at("warnings").get_to(r.warnings);
  for (const Json& f : j.at("figures")) {
    r.figures.push_back({f.at("kind"), f.at("view"), f.at("file"), f.at("width"), f.at("height")});
  }
  if (j.contains("timing_s")) r.timing_s = number_pairs(j.at("timing_s"));
  return r;
}

}  // namespace regarment
