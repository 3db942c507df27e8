#include "evaluation/page_sections.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr std::size_t kMostRows = 60;

void set_verdict(int verdict, Gaps& row) {
  row.set("better", verdict > 0);
  row.set("worse", verdict < 0);
  row.set("same", verdict == 0);
}

Gaps statistic_row(const StatisticChange& change) {
  Gaps row;
  row.set("name", change.name);
  row.set("before", fixed_text(change.before, 3));
  row.set("now", fixed_text(change.now, 3));
  row.set("difference", signed_text(change.now - change.before, 3));
  set_verdict(change.verdict, row);
  return row;
}

Gaps scan_row(const ScanChange& change) {
  Gaps row;
  row.set("name", change.name);
  row.set("before", change.before_cm ? fixed_text(*change.before_cm, 2) : "failed");
  row.set("now", change.now_cm ? fixed_text(*change.now_cm, 2) : "failed");
  const bool both = change.before_cm && change.now_cm;
  row.set("difference", both ? signed_text(*change.now_cm - *change.before_cm, 2) : "–");
  const bool better = both ? *change.now_cm < *change.before_cm : change.now_cm.has_value();
  set_verdict(better ? 1 : -1, row);
  return row;
}

bool of_all_scans(const StatisticChange& change) {
  return change.name.find('.') == std::string::npos;
}

}  // namespace

void show_baseline(const Evaluation& evaluation, Gaps& page) {
  page.set("has_baseline", evaluation.baseline.has_value());
  if (!evaluation.baseline) return;
  const BaselineComparison& baseline = *evaluation.baseline;
  std::vector<Gaps> overall, others, scans;
  std::size_t better = 0, worse = 0;
  for (const StatisticChange& change : baseline.statistics) {
    better += change.verdict > 0 ? 1 : 0;
    worse += change.verdict < 0 ? 1 : 0;
    if (of_all_scans(change)) {
      overall.push_back(statistic_row(change));
    } else if (change.verdict != 0 && others.size() < kMostRows) {
      others.push_back(statistic_row(change));
    }
  }
  for (const ScanChange& change : baseline.scans) {
    if (scans.size() < kMostRows) scans.push_back(scan_row(change));
  }
  page.set("baseline_file", baseline.file);
  page.set("better_count", count_text(better));
  page.set("worse_count", count_text(worse));
  page.set("baseline_overall", std::move(overall));
  page.set("has_baseline_others", !others.empty());
  page.set("baseline_others", std::move(others));
  page.set("has_baseline_scans", !scans.empty());
  page.set("changed_count", count_text(baseline.scans.size()));
  page.set("baseline_scans", std::move(scans));
}

}  // namespace regarment
