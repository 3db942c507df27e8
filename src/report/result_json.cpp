#include <nlohmann/json.hpp>

#include "report/result.h"

namespace regarment {
namespace {

// Keeps the order of the contract, which people read.
using Json = nlohmann::ordered_json;

Json maybe(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

void put(Json& object, const char* key, const std::optional<double>& value) {
  if (value) object[key] = *value;
}

Json from_pairs(const auto& pairs) {
  Json object = Json::object();
  for (const auto& [name, value] : pairs) object[name] = value;
  return object;
}

Json program_json(const Result& r) {
  Json out = {{"name", "regarment"}, {"version", r.version}, {"method", r.method},
              {"seed", r.seed},      {"command", r.command}, {"options", from_pairs(r.options)}};
  if (!r.settings.empty()) out["settings"] = from_pairs(r.settings);
  if (r.refit) out["refit"] = true;
  if (r.threads) out["threads"] = *r.threads;
  return out;
}

Json finding_json(const Finding& f) {
  return {{"code", f.code},
          {"severity", severity_name(f.severity)},
          {"found", f.found},
          {"done", f.done},
          {"advice", f.advice}};
}

Json scan_json(const ResultScan& s) {
  Json findings = Json::array();
  for (const Finding& f : s.findings) findings.push_back(finding_json(f));
  Json out = {{"file", s.file},
              {"sha256", s.sha256},
              {"vertices", s.vertices},
              {"triangles", s.triangles},
              {"units", s.units},
              {"up", s.up},
              {"front", s.front},
              {"units_guessed", s.units_guessed},
              {"up_guessed", s.up_guessed},
              {"front_guessed", s.front_guessed},
              {"front_confidence", s.front_confidence},
              {"height_cm", s.height_cm},
              {"spacing_mm", s.spacing_mm},
              {"noise_mm", s.noise_mm},
              {"caps", s.caps},
              {"outliers", s.outliers},
              {"holes", s.holes},
              {"findings", findings}};
  if (s.path) out["path"] = *s.path;
  return out;
}

Json measurement_json(const ResultMeasurement& m) {
  Json out = {{"name", m.name},
              {"code", m.code},
              {"title", m.title},
              {"definition", m.definition},
              {"how_to_measure", m.how_to_measure},
              {"circumference", m.circumference},
              {"value_cm", m.value_cm},
              {"interval_cm", {m.low_cm, m.high_cm}},
              {"worn_cm", maybe(m.worn_cm)},
              {"observable", m.observable},
              {"fixed", m.fixed}};
  put(out, "worn_fit_cm", m.worn_fit_cm);
  put(out, "worn_line_cm", m.worn_line_cm);
  put(out, "worn_scan_cm", m.worn_scan_cm);
  for (const ResultRivalLength& r : m.rivals)
    out["rivals"].push_back({{"edges", r.edges}, {"value_cm", r.value_cm}, {"weight", r.weight}});
  put(out, "truth_cm", m.truth_cm);
  put(out, "error_cm", m.error_cm());
  put(out, "published_cm", m.published_cm);
  put(out, "tol_minus_cm", m.tol_minus_cm);
  put(out, "tol_plus_cm", m.tol_plus_cm);
  return out;
}

Json edge_json(const ResultEdge& e) {
  Json rivals = Json::array();
  for (const ResultRival& r : e.rivals)
    rivals.push_back({{"height_cm", r.height_cm}, {"weight", r.weight}});
  return {{"name", e.name},
          {"evidence", e.evidence},
          {"standard_error_mm", e.standard_error_mm},
          {"coverage", e.coverage},
          {"length_cm", e.length_cm},
          {"flat_cm", maybe(e.flat_cm)},
          {"beside_cm", maybe(e.beside_cm)},
          {"ease_cm", maybe(e.ease_cm())},
          {"height_cm", e.height_cm},
          {"rivals", rivals}};
}

Json error_json(const ResultGarment& g) {
  // Without a search the terms have no weights and no total.
  Json total, silhouette = maybe(g.silhouette);
  if (g.search) {
    total = g.search->total;
    silhouette = g.search->terms.silhouette;
  }
  return {{"total", total},
          {"distance_m", g.mean_distance_m},
          {"stretch", g.mean_stretch},
          {"silhouette", silhouette}};
}

Json search_json(const ResultSearch& s) {
  Json dimensions = Json::array();
  for (const SearchedDimension& d : s.dimensions) {
    dimensions.push_back({{"name", d.name}, {"lower_cm", d.lower_cm}, {"upper_cm", d.upper_cm}});
  }
  return {{"weights",
           {{"alpha", s.weights.alpha}, {"beta", s.weights.beta}, {"gamma", s.weights.gamma}}},
          {"square_root", s.square_root},
          {"kept_run", s.kept},
          {"dimensions", dimensions}};
}

Json runs_json(const ResultSearch& s) {
  Json runs = Json::array();
  for (const ResultRun& run : s.runs) {
    Json lengths = Json::object();
    for (std::size_t d = 0; d < s.dimensions.size(); ++d) {
      lengths[s.dimensions[d].name] = run.dimensions_cm[d];
    }
    runs.push_back(
        {{"seed", run.seed},
         {"ending", run.ending == FitEnding::Converged ? "converged" : "evaluation_limit"},
         {"evaluations", run.evaluations},
         {"unsettled", run.unsettled},
         {"best_evaluation", run.best},
         {"error", run.error},
         {"dimensions_cm", lengths}});
  }
  return runs;
}

Json deviation_json(const ResultDeviation& d) {
  return {{"vertices", d.vertices},
          {"median_mm", d.median_mm},
          {"p95_mm", d.p95_mm},
          {"band_mm", d.band_mm},
          {"within_band", d.within},
          {"range_mm", d.range_mm},
          {"histogram", {{"below", d.below}, {"counts", d.counts}, {"above", d.above}}}};
}

Json garment_json(const ResultGarment& g) {
  Json measurements = Json::array(), edges = Json::array();
  for (const ResultMeasurement& m : g.measurements) measurements.push_back(measurement_json(m));
  for (const ResultEdge& e : g.edges) edges.push_back(edge_json(e));
  Json out = {{"template", g.template_name},  {"title", g.title}, {"layer", g.layer},
              {"measurements", measurements}, {"edges", edges},   {"error", error_json(g)}};
  for (const ResultAsymmetry& a : g.asymmetry)
    out["asymmetry"].push_back({{"name", a.name},
                                {"sides", a.sides},
                                {"difference_cm", a.difference_cm},
                                {"spread_cm", a.spread_cm}});
  if (g.search) out["search"] = search_json(*g.search);
  out["runs"] = g.search ? runs_json(*g.search) : Json::array();
  if (g.deviation) out["deviation"] = deviation_json(*g.deviation);
  out["vertices_labelled"] = g.vertices_labelled;
  return out;
}

Json score_json(const LabelScore& s) {
  Json iou = Json::array();
  for (const auto& one : s.iou) iou.push_back(maybe(one));
  return {{"scored", s.scored}, {"accuracy", s.accuracy}, {"mean_iou", s.mean_iou}, {"iou", iou}};
}

Json segmentation_json(const Result& r) {
  Json out = {{"person", r.person}, {"garments", r.garment_counts}, {"unsure", r.unsure}};
  if (r.label_score) out["truth"] = score_json(*r.label_score);
  return out;
}

Json figure_json(const StoredFigure& f) {
  return {{"kind", f.kind},
          {"view", f.view},
          {"file", f.file},
          {"width", f.width},
          {"height", f.height}};
}

}  // namespace

std::string result_json(const Result& r) {
  Json garments = Json::array(), figures = Json::array();
  for (const ResultGarment& g : r.garments) garments.push_back(garment_json(g));
  for (const StoredFigure& f : r.figures) figures.push_back(figure_json(f));
  Json out = {{"schema", "regarment.result/1"},
              {"program", program_json(r)},
              {"fabric", r.fabric},
              {"scan", scan_json(r.scan)},
              {"garments", garments},
              {"segmentation", segmentation_json(r)},
              {"landmarks_cm", from_pairs(r.landmarks_cm)},
              {"warnings", r.warnings},
              {"figures", figures}};
  if (!r.timing_s.empty()) out["timing_s"] = from_pairs(r.timing_s);
  return out.dump(2) + "\n";
}

}  // namespace regarment
