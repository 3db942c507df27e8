#include <algorithm>
#include <cmath>

#include "evaluation/page_sections.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr std::size_t kMostRows = 2500;

// One dimension that was found.
struct Row {
  const EvaluatedScan* scan = nullptr;
  const TrueDimension* truth = nullptr;
  const FoundDimension* found = nullptr;

  double error() const { return found->value_cm - truth->truth_cm; }
};

std::vector<Row> rows_of(const std::vector<EvaluatedScan>& scans) {
  std::vector<Row> out;
  for (const EvaluatedScan& scan : scans) {
    for (std::size_t d = 0; d < scan.found.size(); ++d) {
      if (scan.found[d]) out.push_back({&scan, &scan.about.dimensions[d], &*scan.found[d]});
    }
  }
  return out;
}

// What the scan shows before what it hides, and the worst first.
bool comes_first(const Row& a, const Row& b) {
  if (a.truth->hidden() != b.truth->hidden()) return b.truth->hidden();
  return std::abs(a.error()) > std::abs(b.error());
}

std::string remark(const Row& row) {
  if (row.truth->hidden()) return row.found->observable ? "hidden, not said" : "hidden, said so";
  return row.found->observable ? "" : "wrongly said hidden";
}

Gaps gaps_of(const Row& row) {
  const TrueDimension& truth = *row.truth;
  Gaps out;
  out.set("name", measurement_name(truth));
  out.set("scan", row.scan->about.name);
  out.set("has_report", !row.scan->report.empty());
  out.set("link", row.scan->report);
  out.set("truth", fixed_text(truth.truth_cm, 1));
  out.set("estimate", fixed_text(row.found->value_cm, 1));
  out.set("interval", row.found->low_cm ? fixed_text(*row.found->low_cm, 1) + "\u2009–\u2009" +
                                              fixed_text(*row.found->high_cm, 1)
                                        : "–");
  out.set("error", signed_text(row.error(), 1));
  out.set("hidden", truth.hidden());
  const auto& published = truth.published_cm;
  out.set("published", figure_text(published, 1));
  out.set("published_error",
          published ? signed_text(*published - truth.truth_cm, 1) : std::string("–"));
  out.set("pass", !truth.hidden() && truth.tolerates(row.error()));
  out.set("fail", !truth.hidden() && !truth.tolerates(row.error()));
  out.set_maybe("remark", remark(row));
  return out;
}

}  // namespace

void show_dimensions(const Evaluation& evaluation, Gaps& page) {
  std::vector<Row> rows = rows_of(evaluation.scans);
  std::stable_sort(rows.begin(), rows.end(), comes_first);
  std::vector<Gaps> shown;
  for (std::size_t i = 0; i < std::min(rows.size(), kMostRows); ++i) {
    shown.push_back(gaps_of(rows[i]));
  }
  page.set("has_dimensions", !rows.empty());
  page.set("dimension_count", count_text(rows.size()));
  page.set("some_dimensions", rows.size() > kMostRows);
  page.set("shown_dimensions", count_text(kMostRows));
  page.set("all_dimensions", std::move(shown));
}

}  // namespace regarment
