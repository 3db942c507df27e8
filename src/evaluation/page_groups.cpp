#include "evaluation/error_plots.h"
#include "evaluation/measurement_plot.h"
#include "evaluation/page_sections.h"
#include "report/text.h"

namespace regarment {
namespace {

std::optional<double> of(const ErrorStatistics& errors, double value) {
  return errors.n == 0 ? std::nullopt : std::optional(value);
}

Gaps group_row(const GroupStatistics& group) {
  const ErrorStatistics& e = group.errors;
  Gaps row;
  row.set("name", group.name);
  row.set("scans", count_text(group.scans));
  row.set("failures", count_text(group.failures));
  row.set("n", count_text(e.n));
  row.set("bias", signed_figure_text(of(e, e.bias_cm), 2));
  row.set("mae", figure_text(of(e, e.mae_cm), 2));
  row.set("rmse", figure_text(of(e, e.rmse_cm), 2));
  row.set("p95", figure_text(of(e, e.p95_cm), 2));
  row.set("worst", figure_text(of(e, e.worst_cm), 2));
  row.set("slope", figure_text(e.slope, 3));
  row.set("sd", figure_text(e.sd_cm, 2));
  row.set("in_tolerance",
          percent_text(of(e, static_cast<double>(group.in_tolerance) / static_cast<double>(e.n))));
  row.set("within_1", percent_text(of(e, e.within_1cm)));
  row.set("coverage", percent_text(e.coverage));
  row.set("width", figure_text(e.median_width_cm, 2));
  row.set("hidden", group.hidden == 0
                        ? "–"
                        : count_text(group.hidden_flagged) + " / " + count_text(group.hidden));
  row.set("wrong", count_text(group.confident_wrong));
  row.set("miou", figure_text(group.miou, 3));
  row.set("border", figure_text(group.border_mm, 1));
  row.set("worn", figure_text(of(group.worn, group.worn.mae_cm), 2));
  row.set("published", figure_text(of(group.published, group.published.mae_cm), 2));
  const bool judged = group.iso.has_value();
  row.set("judged", judged);
  row.set("iso_pass", judged && group.iso->within);
  row.set("iso_fail", judged && !group.iso->within);
  row.set("limit", judged ? fixed_text(10 * group.iso->limit_cm, 0) : "");
  row.set("bias_interval",
          e.bias_low_cm ? signed_text(*e.bias_low_cm, 2) + " to " + signed_text(*e.bias_high_cm, 2)
                        : "–");
  return row;
}

std::vector<Gaps> rows_by(const Evaluation& evaluation, const std::string& by) {
  std::vector<Gaps> rows;
  for (const GroupStatistics& group : evaluation.groups) {
    if (group.by == by) rows.push_back(group_row(group));
  }
  return rows;
}

}  // namespace

void show_groups(const Evaluation& evaluation, Gaps& page) {
  const GroupStatistics& all = evaluation.groups.front();
  page.set("with_published", all.published.n > 0);
  page.set("with_labels", all.labelled > 0);
  page.set("with_worn", all.worn.n > 0);
  auto measurements = rows_by(evaluation, "measurement");
  page.set("has_measurements", !measurements.empty());
  page.set("measurements", std::move(measurements));
  std::vector<Gaps> tables;
  const auto add = [&](const std::string& by, const std::string& title) {
    std::vector<Gaps> rows = rows_by(evaluation, by);
    if (rows.empty() || (by == "damage" && rows.size() == 1)) return;
    Gaps table;
    table.set("by", by);
    table.set("table_title", title);
    table.set("rows", std::move(rows));
    tables.push_back(std::move(table));
  };
  add("template", "Garment");
  add("layer", "Layer");
  add("kind", "Kind of scan");
  add("damage", "Damage");
  page.set("group_tables", std::move(tables));
}

void show_plots(const Evaluation& evaluation, Gaps& page) {
  const std::vector<PlotPoint> points = plot_points(evaluation.scans);
  page.set("has_plots", !points.empty());
  if (points.empty()) return;
  const ErrorStatistics& errors = evaluation.groups.front().errors;
  bool flagged = false;
  for (const PlotPoint& point : points) flagged = flagged || point.flagged;
  page.set("with_flagged", flagged);
  page.set("plot_width", std::to_string(kPlotWidth));
  page.set("plot_height", std::to_string(kPlotHeight));
  page.set("agreement", agreement_plot(points));
  page.set("difference", difference_plot(points, errors));
  const std::vector<MeasurementErrors> rows =
      measurement_errors(evaluation.scans, evaluation.groups);
  page.set("rows_width", std::to_string(kMeasurementPlotWidth));
  page.set("rows_height", std::to_string(measurement_plot_height(rows.size())));
  page.set("rows_plot", measurement_plot(rows));
  page.set("agreement_words", "Slope of estimate on truth " + figure_text(errors.slope, 3) + ".");
  page.set("difference_words", "Mean error " + signed_text(errors.bias_cm, 2) +
                                   " cm, standard deviation " + figure_text(errors.sd_cm, 2) +
                                   " cm.");
}

}  // namespace regarment
