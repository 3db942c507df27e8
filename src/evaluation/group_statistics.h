#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/evaluated_scan.h"
#include "evaluation/iso_verdict.h"
#include "evaluation/statistics.h"

namespace regarment {

/// An estimate counts as wrong, though said to be seen, beyond this, cm.
inline constexpr double kConfidentError = 3.0;

/// Figures of some scans, or of one kind of dimension on them. Dimensions that the truth says are
/// hidden are in no error; those of failed scans are in none either.
struct GroupStatistics {
  std::string by;    // "all", "template", "measurement", "layer", "kind" or "damage"
  std::string key;   // how a gate names it: "", "skirt", "skirt.hip", "inner.skirt.hip", "layer.1",
                     // "kind.cloud", "damage.holes", "damage.none"
  std::string name;  // for a person: "skirt hip"
  std::size_t scans = 0, failures = 0;
  ErrorStatistics errors;         // of the flat values
  std::optional<IsoVerdict> iso;  // of one measurement only
  ErrorStatistics worn,
      published;  // where both are known; published: the same dimensions by others
  std::size_t hidden = 0, hidden_flagged = 0;      // hidden dimensions, and those said to be so
  std::size_t visible = 0, visible_flagged = 0;    // the others, and those said to be hidden
  std::size_t confident = 0, confident_wrong = 0;  // visible and said to be seen; far off
  std::size_t in_tolerance = 0;                    // of `errors`, see TrueDimension::tolerates
  std::size_t frames = 0, frames_wrong = 0;        // scans with a known frame; units or axes wrong
  std::size_t labelled = 0;                        // scans with true labels
  std::optional<double> miou, border_mm;           // means over these
  std::vector<std::pair<std::string, double>> class_iou;  // of all scans only; means, by name
  std::optional<double> seconds_median, seconds_p95;      // of a scan
};

/// How a gate names the measurement of a dimension, "skirt.hip" or, of a garment below another,
/// "inner.skirt.hip"; and its name for a person.
std::string measurement_key(const TrueDimension& dimension);
std::string measurement_name(const TrueDimension& dimension);

/// The groups the cases fall into: all, then templates, measurements, layers, kinds and damages,
/// each sorted by key, measurements of garments below others last. A group of a measurement has the
/// dimensions of outermost garments; those of garments below have one of their own, "inner." before
/// its key.
std::vector<GroupStatistics> group_statistics(const std::vector<EvaluatedScan>& scans);

}  // namespace regarment
