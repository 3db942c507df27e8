#pragma once

#include "evaluation/evaluation.h"

namespace regarment {

inline TrueDimension dimension(const std::string& garment, const std::string& measurement,
                               double truth_cm, int layer = 1) {
  TrueDimension out;
  out.layer = layer, out.template_name = garment, out.measurement = measurement;
  out.circumference = measurement != "length";
  out.truth_cm = truth_cm;
  return out;
}

/// A scan of a skirt whose `measurement`s are off by `errors` (cm), with intervals of +-2 cm.
inline EvaluatedScan skirt_scan(const std::string& name, const std::vector<double>& errors) {
  const std::vector<std::pair<std::string, double>> truths = {
      {"length", 54}, {"width", 110}, {"waist", 78}, {"hip", 94}};
  EvaluatedScan out;
  out.about.name = name;
  out.about.scan = name + ".ply";
  out.about.garments = {"skirt"};
  out.about.kind = "closed";
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double value = truths.at(i).second + errors[i];
    out.about.dimensions.push_back(dimension("skirt", truths[i].first, truths[i].second));
    out.found.push_back(FoundDimension{value, value - 2, value + 2, {}, true});
  }
  return out;
}

inline EvaluatedScan failed(const std::string& name, const std::string& kind = "crash") {
  EvaluatedScan out = skirt_scan(name, {0, 0});
  out.found.clear();
  out.failure = ScanFailure{kind, 139, "ended by signal 11"};
  return out;
}

inline Evaluation evaluation_of(std::vector<EvaluatedScan> scans) {
  Evaluation out;
  out.version = "0.0.0";
  out.table = "truth.csv";
  out.scans = std::move(scans);
  out.groups = group_statistics(out.scans);
  return out;
}

inline const GroupStatistics* find_group(const std::vector<GroupStatistics>& groups,
                                         const std::string& key) {
  for (const GroupStatistics& group : groups) {
    if (group.key == key) return &group;
  }
  return nullptr;
}

}  // namespace regarment
