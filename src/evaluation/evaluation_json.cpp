#include "evaluation/evaluation_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "evaluation/named_statistics.h"
#include "evaluation/repeats.h"
#include "report/text.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 4;

Json number(const std::optional<double>& value) {
  if (!value) return nullptr;
  const double short_value = rounded(*value, kDigits);
  // Counts look like counts.
  if (short_value == std::floor(short_value) && std::abs(short_value) < 1e15) {
    return static_cast<std::int64_t>(short_value);
  }
  return short_value;
}

Json group_json(const GroupStatistics& group) {
  Json values = Json::object();
  for (const NamedStatistic& one : named_statistics()) {
    values[std::string(one.name)] = number(one.value(group));
  }
  Json out = {{"by", group.by}, {"key", group.key}, {"name", group.name}, {"values", values}};
  if (group.by == "all") {
    Json classes = Json::object();
    for (const auto& [name, iou] : group.class_iou) classes[name] = number(iou);
    out["class_iou"] = classes;
  }
  return out;
}

Json dimension_json(const EvaluatedScan& scan, std::size_t d) {
  const TrueDimension& truth = scan.about.dimensions[d];
  Json out = {{"layer", truth.layer},
              {"template", truth.template_name},
              {"measurement", truth.measurement},
              {"truth_cm", number(truth.truth_cm)}};
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) out[name] = number(value);
  };
  add("worn_truth_cm", truth.worn_cm);
  add("published_cm", truth.published_cm);
  if (truth.observable) out["truth_observable"] = *truth.observable;
  if (d >= scan.found.size() || !scan.found[d]) return out;
  const FoundDimension& found = *scan.found[d];
  add("estimate_cm", found.value_cm);
  add("low_cm", found.low_cm);
  add("high_cm", found.high_cm);
  add("worn_cm", found.worn_cm);
  out["observable"] = found.observable;
  add("error_cm", found.value_cm - truth.truth_cm);
  return out;
}

Json scan_json(const EvaluatedScan& scan) {
  Json out = {{"name", scan.about.name},
              {"file", scan.about.scan.filename().string()},
              {"garment", scan.about.garment},
              {"kind", scan.about.kind},
              {"damage", scan.about.damage},
              {"garments", scan.about.garments},
              {"mean_error_cm", number(scan.mean_error_cm())}};
  if (scan.failure) {
    out["failure"] = {{"kind", scan.failure->kind},
                      {"status", scan.failure->status},
                      {"line", scan.failure->line}};
  }
  if (scan.labels) {
    Json classes = Json::array();
    for (const auto& [name, iou] : scan.labels->class_iou) {
      classes.push_back({{"name", name}, {"iou", number(iou)}});
    }
    out["labels"] = {{"miou", number(scan.labels->mean_iou)},
                     {"classes", classes},
                     {"border_mm", number(scan.labels->border_mm)}};
  }
  if (scan.frame_right) out["frame_right"] = *scan.frame_right;
  if (scan.seconds) out["seconds"] = number(scan.seconds);
  const std::string fit = "fits/" + scan.about.name;
  if (scan.report == fit + "/report.html") {
    out["fit"] = fit;
  } else if (!scan.report.empty()) {
    out["report"] = scan.report;
  }
  Json dimensions = Json::array();
  for (std::size_t d = 0; d < scan.about.dimensions.size(); ++d) {
    dimensions.push_back(dimension_json(scan, d));
  }
  out["dimensions"] = dimensions;
  return out;
}

Json repeats_json(const std::vector<EvaluatedScan>& scans) {
  const std::vector<RepeatedDimension> repeats = repeated_dimensions(scans);
  Json summaries = Json::array(), garments = Json::array();
  for (const RepeatSummary& one : repeat_summaries(repeats)) {
    summaries.push_back({{"key", one.key},
                         {"garments", one.garments},
                         {"scans", one.scans},
                         {"within_sd_cm", number(one.within_sd_cm)},
                         {"single_mae_cm", number(one.single_mae_cm)},
                         {"pooled_mae_cm", number(one.pooled_mae_cm)}});
  }
  for (const RepeatedDimension& one : repeats) {
    garments.push_back({{"garment", one.garment},
                        {"key", one.key},
                        {"truth_cm", number(one.truth_cm)},
                        {"scans", one.scans},
                        {"mean_error_cm", number(one.mean_error_cm)},
                        {"sd_cm", number(one.sd_cm)},
                        {"range_cm", number(one.range_cm)}});
  }
  return {{"measurements", summaries}, {"garments", garments}};
}

Json baseline_json(const BaselineComparison& baseline) {
  const auto word = [](int verdict) {
    if (verdict == 0) return "same";
    return verdict > 0 ? "better" : "worse";
  };
  Json statistics = Json::array(), scans = Json::array();
  for (const StatisticChange& change : baseline.statistics) {
    statistics.push_back({{"name", change.name},
                          {"before", number(change.before)},
                          {"now", number(change.now)},
                          {"verdict", word(change.verdict)}});
  }
  for (const ScanChange& change : baseline.scans) {
    scans.push_back({{"name", change.name},
                     {"before_cm", number(change.before_cm)},
                     {"now_cm", number(change.now_cm)}});
  }
  return {{"file", baseline.file}, {"statistics", statistics}, {"scans", scans}};
}

}  // namespace

std::string evaluation_json(const Evaluation& evaluation) {
  Json groups = Json::array(), gates = Json::array(), scans = Json::array();
  for (const GroupStatistics& group : evaluation.groups) groups.push_back(group_json(group));
  for (const GateResult& gate : evaluation.gates) {
    gates.push_back({{"gate", gate.text}, {"value", number(gate.value)}, {"passed", gate.passed}});
  }
  for (const EvaluatedScan& scan : evaluation.scans) scans.push_back(scan_json(scan));
  Json out = {{"schema", "regarment.evaluation/1"},
              {"program", {{"name", "regarment"}, {"version", evaluation.version}}},
              {"table", evaluation.table}};
  if (evaluation.estimates) out["estimates"] = *evaluation.estimates;
  out["fit_options"] = evaluation.fit_options;
  out["statistics"] = groups;
  out["gates"] = gates;
  if (evaluation.baseline) out["baseline"] = baseline_json(*evaluation.baseline);
  out["repeats"] = repeats_json(evaluation.scans);
  out["scans"] = scans;
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace regarment
