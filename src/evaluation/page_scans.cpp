#include <array>
#include <cmath>
#include <map>

#include "evaluation/confusion_picture.h"
#include "evaluation/evaluation_page.h"
#include "evaluation/page_sections.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string words(const std::vector<std::string>& list) {
  std::string out;
  for (const std::string& word : list) out += (out.empty() ? "" : ", ") + word;
  return out;
}

std::string dimension_name(const EvaluatedScan& scan, const TrueDimension& d) {
  const std::string name = d.measurement;
  std::string out = scan.about.garments.size() > 1 ? d.template_name + " " + name : name;
  for (char& c : out) {
    if (c == '_') c = ' ';
  }
  return out;
}

std::string remark_on(const TrueDimension& truth, const std::optional<FoundDimension>& found) {
  const bool flagged = found && !found->observable;
  if (truth.hidden()) return flagged ? "hidden, and said so" : "hidden, not said";
  return flagged ? "wrongly said hidden" : "";
}

Gaps dimension_row(const EvaluatedScan& scan, std::size_t d) {
  const TrueDimension& truth = scan.about.dimensions[d];
  const auto& found = scan.found[d];
  Gaps row;
  row.set("name", dimension_name(scan, truth));
  row.set("truth", fixed_text(truth.truth_cm, 1));
  row.set("estimate", figure_text(found ? std::optional(found->value_cm) : std::nullopt, 1));
  row.set("interval", found && found->low_cm ? fixed_text(*found->low_cm, 1) + "\u2009–\u2009" +
                                                   fixed_text(*found->high_cm, 1)
                                             : "–");
  row.set("error", found ? signed_text(found->value_cm - truth.truth_cm, 1) : "–");
  row.set("hidden", truth.hidden());
  row.set_maybe("remark", remark_on(truth, found));
  return row;
}

void set_common(const EvaluatedScan& scan, Gaps& out) {
  out.set("name", scan.about.name);
  out.set("garment", scan.about.garment);
  out.set("kind", scan.about.kind);
  out.set("garments", words(scan.about.garments));
  out.set_maybe("damage", words(scan.about.damage));
  out.set("has_report", !scan.report.empty());
  out.set("link", scan.report);
  out.set("error", figure_text(scan.mean_error_cm(), 2));
  const auto& labels = scan.labels;
  out.set("with_iou", labels.has_value());
  out.set("miou", figure_text(labels ? std::optional(labels->mean_iou) : std::nullopt, 3));
  out.set("border", figure_text(labels ? labels->border_mm : std::nullopt, 1));
  out.set("seconds", figure_text(scan.seconds, 1));
}

Gaps worst_case(const Evaluation& evaluation, std::size_t index) {
  const EvaluatedScan& scan = evaluation.scans[index];
  Gaps out;
  set_common(scan, out);
  std::vector<Gaps> rows;
  for (std::size_t d = 0; d < scan.found.size(); ++d) rows.push_back(dimension_row(scan, d));
  out.set("dimensions", std::move(rows));
  out.set("has_picture", false);
  for (const ConfusionPicture& picture : evaluation.pictures) {
    if (picture.scan != index) continue;
    out.set("has_picture", true);
    out.set("source", "data:image/webp;base64," + base64(picture.webp));
    out.set("width", std::to_string(picture.width));
    out.set("height", std::to_string(picture.height));
  }
  return out;
}

std::vector<Gaps> picture_colours() {
  constexpr std::array<std::pair<Confusion, const char*>, 5> kMeanings = {
      {{Confusion::RightGarment, "garment, found"},
       {Confusion::RightPerson, "person, found"},
       {Confusion::Missed, "garment missed"},
       {Confusion::Wrong, "labelled as a garment that is not there"},
       {Confusion::NotScored, "not scored"}}};
  std::vector<Gaps> out;
  for (const auto& [confusion, meaning] : kMeanings) {
    const Colour c = confusion_colour(confusion);
    Gaps one;
    one.set("meaning", std::string(meaning));
    one.set("colour", "rgb(" + std::to_string(c[0]) + "," + std::to_string(c[1]) + "," +
                          std::to_string(c[2]) + ")");
    out.push_back(std::move(one));
  }
  return out;
}

// By kind of failure, and how often.
std::string failure_kinds(const std::vector<EvaluatedScan>& scans) {
  std::map<std::string, std::size_t> counts;
  for (const EvaluatedScan& scan : scans) {
    if (scan.failure) ++counts[scan.failure->kind];
  }
  std::string out;
  for (const auto& [kind, count] : counts) {
    out += (out.empty() ? "" : ", ") + kind + ": " + count_text(count);
  }
  return out;
}

double largest_error(const EvaluatedScan& scan) {
  double largest = 0;
  for (std::size_t d = 0; d < scan.found.size(); ++d) {
    if (!scan.found[d] || scan.about.dimensions[d].hidden()) continue;
    const double error = scan.found[d]->value_cm - scan.about.dimensions[d].truth_cm;
    if (std::abs(error) > std::abs(largest)) largest = error;
  }
  return largest;
}

}  // namespace

void show_scans(const Evaluation& evaluation, Gaps& page) {
  std::vector<Gaps> worst, failures, all;
  for (const std::size_t i : worst_scans(evaluation)) worst.push_back(worst_case(evaluation, i));
  bool timed = false;
  for (const EvaluatedScan& scan : evaluation.scans) {
    Gaps row;
    set_common(scan, row);
    row.set("failed", scan.failure.has_value());
    row.set("largest", scan.mean_error_cm() ? signed_text(largest_error(scan), 1) : "–");
    timed = timed || scan.seconds.has_value();
    if (scan.failure) {
      row.set("why", scan.failure->kind);
      row.set("line", scan.failure->line);
      failures.push_back(row);
    }
    all.push_back(std::move(row));
  }
  page.set("has_worst", !worst.empty());
  page.set("worst_scans", std::move(worst));
  page.set("with_pictures", !evaluation.pictures.empty());
  page.set("colours", picture_colours());
  page.set("has_failures", !failures.empty());
  page.set("failure_kinds", failure_kinds(evaluation.scans));
  page.set("failed_scans", std::move(failures));
  page.set("with_seconds", timed);
  page.set("scans", std::move(all));
}

}  // namespace regarment
