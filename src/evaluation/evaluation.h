#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/group_statistics.h"

namespace regarment {

/// What a condition on a statistic came to.
struct GateResult {
  std::string text;             // as it was asked for
  std::optional<double> value;  // of the statistic; none where nothing could be measured
  bool passed = false;
};

/// A statistic now and before.
struct StatisticChange {
  std::string name;  // as a gate names it
  double before = 0, now = 0;
  int verdict = 0;  // 1 better, -1 worse, 0 as it was
};

/// A scan now and before: the mean absolute error of its dimensions, cm; none where it failed or
/// was not there.
struct ScanChange {
  std::string name;
  std::optional<double> before_cm, now_cm;
};

struct BaselineComparison {
  std::string file;  // its name
  std::vector<StatisticChange> statistics;
  std::vector<ScanChange> scans;  // only those that changed
};

/// A picture of where labels and truth agree, in the page.
struct ConfusionPicture {
  std::size_t scan = 0;  // into Evaluation::scans
  std::string webp;      // bytes
  int width = 0, height = 0;
};

/// Everything that was found for a table of scans: plain data, enough for the page, JSON and CSV.
struct Evaluation {
  std::string version;                   // of the program
  std::string table;                     // name of its file
  std::vector<std::string> fit_options;  // given to every fit
  std::optional<std::string> estimates;  // name of the table compared; none: fits were made
  bool timing = true;
  std::vector<EvaluatedScan> scans;
  std::vector<GroupStatistics> groups;  // the first is that of all scans
  std::vector<GateResult> gates;
  std::optional<BaselineComparison> baseline;
  std::vector<ConfusionPicture> pictures;
};

}  // namespace regarment
