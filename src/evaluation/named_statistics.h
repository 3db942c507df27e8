#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/group_statistics.h"

namespace regarment {

/// What makes a figure a better one.
enum class Better { Neither, Smaller, Larger, NearZero, NearOne, NearNinety };

/// A figure of a group as gates, JSON and baselines name it.
struct NamedStatistic {
  std::string_view name;  // "mae_cm"
  Better better;
  std::optional<double> (*value)(const GroupStatistics&);
};

/// All there are, in the order of the JSON. Counts and shares are plain numbers; `iso_within` is 1
/// or 0.
const std::vector<NamedStatistic>& named_statistics();

/// "skirt.hip.mae_cm": key and name with a point between, or the name alone for all scans.
std::string full_name(const GroupStatistics& group, std::string_view statistic);

/// Whether `now` is better (1) or worse (-1) than `before`; 0 when they are alike to 0.0005 or
/// neither is better.
int compare(Better better, double before, double now);

}  // namespace regarment
