#include "evaluation/baseline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "evaluation/named_statistics.h"
#include "report/json_schema.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

constexpr double kAlike = 0.0005;  // cm

// A scan that failed before or now has changed more than any that did not.
double size_of(const ScanChange& change) {
  if (!change.before_cm || !change.now_cm) return std::numeric_limits<double>::infinity();
  return std::abs(*change.now_cm - *change.before_cm);
}

bool alike(const std::optional<double>& before, const std::optional<double>& now) {
  if (before.has_value() != now.has_value()) return false;
  return !before || std::abs(*now - *before) <= kAlike;
}

}  // namespace

Baseline parse_baseline(const std::string& text, const std::string& name) {
  check_by_schema(text, "evaluation.schema.json", name,
                  "give an evaluation.json that 'regarment evaluate' wrote");
  const Json json = Json::parse(text);
  Baseline out;
  out.file = name;
  for (const Json& group : json.at("statistics")) {
    const std::string key = group.at("key").get<std::string>();
    const std::string prefix = key.empty() ? "" : key + ".";
    for (const auto& [statistic, value] : group.at("values").items()) {
      if (!value.is_number()) continue;
      out.statistics[prefix + statistic] = value.get<double>();
    }
  }
  for (const Json& scan : json.at("scans")) {
    const Json& error = scan.at("mean_error_cm");
    out.scans[scan.at("name").get<std::string>()] =
        error.is_number() ? std::optional(error.get<double>()) : std::nullopt;
  }
  return out;
}

BaselineComparison compare_with(const Baseline& before, const Evaluation& now) {
  BaselineComparison out;
  out.file = before.file;
  for (const GroupStatistics& group : now.groups) {
    for (const NamedStatistic& one : named_statistics()) {
      const std::string name = full_name(group, one.name);
      const auto old = before.statistics.find(name);
      const std::optional<double> value = one.value(group);
      if (one.better == Better::Neither || !value || old == before.statistics.end()) continue;
      out.statistics.push_back(
          {name, old->second, *value, compare(one.better, old->second, *value)});
    }
  }
  for (const EvaluatedScan& scan : now.scans) {
    const auto old = before.scans.find(scan.about.name);
    const std::optional<double> error = scan.mean_error_cm();
    if (old == before.scans.end() || alike(old->second, error)) continue;
    out.scans.push_back({scan.about.name, old->second, error});
  }
  std::stable_sort(out.scans.begin(), out.scans.end(),
                   [](const auto& a, const auto& b) { return size_of(a) > size_of(b); });
  return out;
}

}  // namespace regarment
