#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_schema.h"
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
  if (r.threads) out["threads"] = *r.threads;
  return out;
}

Json scan_json(const ResultScan& s) {
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
              {"holes", s.holes}};
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
              {"observable", m.observable}};
  put(out, "truth_cm", m.truth_cm);
  put(out, "error_cm", m.error_cm());
  put(out, "published_cm", m.published_cm);
  put(out, "tol_minus_cm", m.tol_minus_cm);
  put(out, "tol_plus_cm", m.tol_plus_cm);
  return out;
}

Json edge_json(const ResultEdge& e) {
  return {{"name", e.name},
          {"evidence", e.evidence},
          {"standard_error_mm", e.standard_error_mm},
          {"coverage", e.coverage},
          {"length_cm", e.length_cm},
          {"height_cm", e.height_cm}};
}

Json garment_json(const ResultGarment& g) {
  Json measurements = Json::array(), edges = Json::array();
  for (const ResultMeasurement& m : g.measurements) measurements.push_back(measurement_json(m));
  for (const ResultEdge& e : g.edges) edges.push_back(edge_json(e));
  return {{"template", g.template_name},
          {"title", g.title},
          {"layer", g.layer},
          {"measurements", measurements},
          {"edges", edges},
          // The direct method measures and does not search: no total, no silhouette, no runs.
          {"error",
           {{"total", nullptr},
            {"distance_m", g.mean_distance_m},
            {"stretch", g.mean_stretch},
            {"silhouette", nullptr}}},
          {"runs", Json::array()},
          {"vertices_labelled", g.vertices_labelled}};
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
  m.worn_cm = optional_number(j, "worn_cm");
  m.truth_cm = optional_number(j, "truth_cm");
  m.published_cm = optional_number(j, "published_cm");
  m.tol_minus_cm = optional_number(j, "tol_minus_cm");
  m.tol_plus_cm = optional_number(j, "tol_plus_cm");
  return m;
}

ResultGarment read_garment(const Json& j) {
  ResultGarment g;
  j.at("template").get_to(g.template_name);
  j.at("title").get_to(g.title);
  j.at("layer").get_to(g.layer);
  j.at("error").at("distance_m").get_to(g.mean_distance_m);
  j.at("error").at("stretch").get_to(g.mean_stretch);
  j.at("vertices_labelled").get_to(g.vertices_labelled);
  for (const Json& m : j.at("measurements")) g.measurements.push_back(read_measurement(m));
  for (const Json& e : j.at("edges")) {
    g.edges.push_back({e.at("name"), e.at("evidence"), e.at("standard_error_mm"), e.at("coverage"),
                       e.at("length_cm"), e.at("height_cm")});
  }
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
  if (j.contains("path")) s.path = j.at("path").get<std::string>();
  return s;
}

void read_program(const Json& j, Result& r) {
  j.at("version").get_to(r.version);
  j.at("method").get_to(r.method);
  j.at("command").get_to(r.command);
  j.at("seed").get_to(r.seed);
  for (const auto& [name, value] : j.at("options").items()) r.options.emplace_back(name, value);
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

std::string result_json(const Result& r) {
  Json garments = Json::array(), figures = Json::array();
  for (const ResultGarment& g : r.garments) garments.push_back(garment_json(g));
  for (const StoredFigure& f : r.figures) figures.push_back(figure_json(f));
  Json out = {{"schema", "regarment.result/1"},
              {"program", program_json(r)},
              {"scan", scan_json(r.scan)},
              {"garments", garments},
              {"segmentation", segmentation_json(r)},
              {"landmarks_cm", from_pairs(r.landmarks_cm)},
              {"warnings", r.warnings},
              {"figures", figures}};
  if (!r.timing_s.empty()) out["timing_s"] = from_pairs(r.timing_s);
  return out.dump(2) + "\n";
}

Result parse_result(const std::string& text, const std::string& name) {
  check_by_result_schema(text, name);
  const Json j = Json::parse(text);
  Result r;
  read_program(j.at("program"), r);
  r.scan = read_scan(j.at("scan"));
  for (const Json& g : j.at("garments")) r.garments.push_back(read_garment(g));
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
