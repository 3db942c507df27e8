#include <algorithm>

#include "evaluation/page_sections.h"
#include "evaluation/repeats.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr std::size_t kMostRows = 600;

Gaps summary_row(const RepeatSummary& summary) {
  Gaps row;
  row.set("name", summary.name);
  row.set("garments", count_text(summary.garments));
  row.set("scans", count_text(summary.scans));
  row.set("within_sd", fixed_text(summary.within_sd_cm, 2));
  row.set("single", fixed_text(summary.single_mae_cm, 2));
  row.set("pooled", fixed_text(summary.pooled_mae_cm, 2));
  return row;
}

Gaps repeat_row(const RepeatedDimension& repeat) {
  Gaps row;
  std::string scans;
  for (std::size_t i = 0; i < repeat.scans.size(); ++i) {
    scans += (i > 0 ? ", " : "") + repeat.scans[i] + " " + signed_text(repeat.errors_cm[i], 1);
  }
  row.set("garment", repeat.garment);
  row.set("name", repeat.name);
  row.set("truth", fixed_text(repeat.truth_cm, 1));
  row.set("pooled", fixed_text(repeat.truth_cm + repeat.mean_error_cm, 1));
  row.set("error", signed_text(repeat.mean_error_cm, 2));
  row.set("sd", fixed_text(repeat.sd_cm, 2));
  row.set("range", fixed_text(repeat.range_cm, 2));
  row.set("scans", scans);
  return row;
}

}  // namespace

void show_repeats(const Evaluation& evaluation, Gaps& page) {
  std::vector<RepeatedDimension> repeats = repeated_dimensions(evaluation.scans);
  std::vector<Gaps> summaries, rows;
  for (const RepeatSummary& one : repeat_summaries(repeats)) summaries.push_back(summary_row(one));
  std::stable_sort(repeats.begin(), repeats.end(),
                   [](const auto& a, const auto& b) { return a.range_cm > b.range_cm; });
  for (std::size_t i = 0; i < std::min(repeats.size(), kMostRows); ++i) {
    rows.push_back(repeat_row(repeats[i]));
  }
  page.set("has_repeats", !repeats.empty());
  page.set("repeat_summaries", std::move(summaries));
  page.set("repeat_count", count_text(repeats.size()));
  page.set("some_repeats", repeats.size() > kMostRows);
  page.set("shown_repeats", count_text(kMostRows));
  page.set("repeats", std::move(rows));
}

}  // namespace regarment
