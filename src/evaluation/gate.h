#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation.h"

namespace regarment {

/// A condition on a statistic: "skirt.hip.mae_cm <= 1.0".
struct Gate {
  std::string text;        // as given
  std::string group;       // "skirt.hip", empty for all scans
  std::string statistic;   // "mae_cm"
  std::string comparison;  // "<=", ">=", "<" or ">"
  double limit = 0;
};

/// Reads one. Throws UsageError when it is no condition or names no statistic there is; whether
/// there is such a group shows `check_gate_groups`.
Gate parse_gate(const std::string& text);

/// Throws UsageError naming the groups there are when a gate names another. `groups` are those of
/// the cases before any fit; what kind of scan a file holds is not known then, so "kind.cloud",
/// "kind.open" and "kind.closed" always pass.
void check_gate_groups(const std::vector<Gate>& gates, const std::vector<GroupStatistics>& groups);

/// What the gates came to. One whose statistic has no value has not passed.
std::vector<GateResult> judge(const std::vector<Gate>& gates,
                              const std::vector<GroupStatistics>& groups);

/// "mae_cm is 1.25, not <= 1.0", for a gate that failed.
std::string why_failed(const GateResult& gate);

}  // namespace regarment
