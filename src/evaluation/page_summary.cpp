#include <algorithm>

#include "evaluation/gate.h"
#include "evaluation/page_sections.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string counted(std::size_t count, const std::string& one) {
  return count_text(count) + " " + one + (count == 1 ? "" : "s");
}

bool has_truth(const Evaluation& evaluation) {
  return std::any_of(evaluation.scans.begin(), evaluation.scans.end(),
                     [](const EvaluatedScan& scan) { return !scan.about.dimensions.empty(); });
}

std::string headline(const Evaluation& evaluation) {
  std::size_t failed = 0;
  for (const GateResult& gate : evaluation.gates) failed += gate.passed ? 0 : 1;
  if (failed > 0)
    return counted(failed, "gate") + " of " + count_text(evaluation.gates.size()) + " failed";
  if (!evaluation.gates.empty()) return "All gates passed";
  const GroupStatistics& all = evaluation.groups.front();
  if (!has_truth(evaluation)) return counted(all.scans - all.failures, "scan") + " measured";
  if (all.errors.n == 0) return "Nothing could be measured";
  return "On average " + fixed_text(all.errors.mae_cm, 2) + " cm off";
}

std::string sentence(const Evaluation& evaluation) {
  const GroupStatistics& all = evaluation.groups.front();
  if (!has_truth(evaluation)) return "The table says nothing of their true sizes.";
  std::string out = counted(all.errors.n, "dimension") + " of " + counted(all.scans, "scan") +
                    " compared with the truth.";
  if (all.errors.n > 0) {
    out += " " + percent_text(all.errors.within_1cm) + " of the errors are at most 1 cm, " +
           percent_text(all.errors.within_2cm) + " at most 2 cm; the median is " +
           signed_text(all.errors.median_cm, 2) + " cm.";
  }
  return out;
}

Gaps key_figure(const std::string& name, const std::string& value, const std::string& note) {
  Gaps out;
  out.set("name", name);
  out.set("value", value);
  out.set_maybe("note", note);
  return out;
}

std::string bias_note(const ErrorStatistics& e) {
  if (!e.bias_low_cm) return "mean error, cm";
  return "mean error, cm; 95\u00a0% " + signed_text(*e.bias_low_cm, 2) + " to " +
         signed_text(*e.bias_high_cm, 2);
}

std::vector<Gaps> label_figures(const GroupStatistics& all) {
  if (!all.miou) return {};
  std::string classes;
  for (const auto& [name, iou] : all.class_iou) {
    classes += (classes.empty() ? "" : ", ") + name + " " + fixed_text(iou, 3);
  }
  std::vector<Gaps> out = {key_figure("Labels, mean IoU", figure_text(all.miou, 3), classes)};
  out.push_back(key_figure("Border", figure_text(all.border_mm, 1),
                           "mm between the label borders found and the true ones"));
  return out;
}

std::vector<Gaps> error_figures(const GroupStatistics& all) {
  const ErrorStatistics& e = all.errors;
  const bool any = e.n > 0;
  const auto of = [&](double value) { return any ? std::optional(value) : std::nullopt; };
  return {key_figure("MAE", figure_text(of(e.mae_cm), 2), "mean absolute error, cm"),
          key_figure("Bias", signed_figure_text(of(e.bias_cm), 2), bias_note(e)),
          key_figure("RMSE", figure_text(of(e.rmse_cm), 2), "cm; SD " + figure_text(e.sd_cm, 2)),
          key_figure("95 % within", figure_text(of(e.p95_cm), 2),
                     "cm; worst " + figure_text(of(e.worst_cm), 2)),
          key_figure("Slope", figure_text(e.slope, 3), "of estimate on truth; 1 is right"),
          key_figure("Coverage", percent_text(e.coverage), "of 90\u00a0% intervals hold the truth"),
          key_figure("Interval width", figure_text(e.median_width_cm, 2),
                     "cm, median; Winkler score " + figure_text(e.interval_score_cm, 2)),
          key_figure("Confident and wrong", count_text(all.confident_wrong),
                     "of " + count_text(all.confident) + " said to be seen are over 3 cm off"),
          key_figure("Hidden, and said so",
                     count_text(all.hidden_flagged) + " / " + count_text(all.hidden),
                     count_text(all.visible_flagged) + " of " + count_text(all.visible) +
                         " visible ones wrongly flagged")};
}

std::vector<Gaps> key_figures(const Evaluation& evaluation) {
  const GroupStatistics& all = evaluation.groups.front();
  std::vector<Gaps> out;
  if (has_truth(evaluation)) out = error_figures(all);
  if (all.frames > 0) {
    out.push_back(key_figure("Units and axes wrong", count_text(all.frames_wrong),
                             "of " + counted(all.frames, "scan") + " with a known frame"));
  }
  for (Gaps& one : label_figures(all)) out.push_back(std::move(one));
  if (all.worn.n > 0) {
    out.push_back(key_figure("Worn lengths, MAE", figure_text(all.worn.mae_cm, 2),
                             "cm; bias " + signed_text(all.worn.bias_cm, 2)));
  }
  if (all.published.n > 0) {
    out.push_back(key_figure("Published, MAE", figure_text(all.published.mae_cm, 2),
                             "cm, of others for " + counted(all.published.n, "dimension")));
  }
  out.push_back(
      key_figure("Failures", count_text(all.failures), "of " + counted(all.scans, "scan")));
  if (all.seconds_median) {
    out.push_back(key_figure("Time of a scan", figure_text(all.seconds_median, 1),
                             "s, median; 95\u00a0% " + figure_text(all.seconds_p95, 1)));
  }
  return out;
}

}  // namespace

void show_summary(const Evaluation& evaluation, Gaps& page) {
  const GroupStatistics& all = evaluation.groups.front();
  page.set("title", counted(all.scans, "scan") + " evaluated");
  page.set("headline", headline(evaluation));
  page.set("sentence", sentence(evaluation));
  bool look = all.failures > 0;
  std::vector<Gaps> gates;
  for (const GateResult& gate : evaluation.gates) {
    Gaps one;
    one.set("gate", gate.text);
    one.set("value", gate.value ? significant_text(*gate.value, 4) : "–");
    one.set("pass", gate.passed);
    one.set("fail", !gate.passed);
    gates.push_back(std::move(one));
    look = look || !gate.passed;
  }
  // Without gates nobody said what is good.
  page.set("is_clear", !look && !gates.empty());
  page.set("needs_a_look", look);
  page.set("has_gates", !gates.empty());
  page.set("gates", std::move(gates));
  page.set("figures", key_figures(evaluation));
}

}  // namespace regarment
