#include "report/search_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/text.h"

namespace regarment {
namespace {

constexpr std::size_t kMostShown = 6;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kShownTries = 0.96;  // share of the dots that must lie within the axis
constexpr int kWideWidth = 420, kWideHeight = 250;

std::vector<std::size_t> best_so_far(const std::vector<double>& error) {
  std::vector<std::size_t> out;
  std::size_t best = kNone;
  for (std::size_t i = 0; i < error.size(); ++i) {
    if (!std::isnan(error[i]) && (best == kNone || error[i] < error[best])) best = i;
    out.push_back(best);
  }
  return out;
}

std::vector<double> all_tried(const Chart& chart) {
  std::vector<double> out;
  for (const ChartRun& run : chart.runs) {
    out.insert(out.end(), run.tried.begin(), run.tried.end());
  }
  return out;
}

std::vector<double> all_found(const Chart& chart) {
  std::vector<double> out;
  for (const ChartRun& run : chart.runs) {
    out.insert(out.end(), run.found.begin(), run.found.end());
  }
  return out;
}

std::string cm(double value_cm) { return cm_text(value_cm / 100.0); }

}  // namespace

std::vector<ShownRun> runs_to_show(const ResultSearch& search) {
  std::vector<std::size_t> order;
  for (std::size_t r = 0; r < search.runs.size(); ++r) order.push_back(r);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if ((a + 1 == search.kept) != (b + 1 == search.kept)) return a + 1 == search.kept;
    return search.runs[a].error < search.runs[b].error;
  });
  order.resize(std::min(order.size(), kMostShown));
  std::sort(order.begin(), order.end());
  std::vector<ShownRun> out;
  int style = 0;
  for (const std::size_t r : order) out.push_back({r, r + 1 == search.kept ? 0 : ++style});
  return out;
}

SearchCharts::SearchCharts(const ResultGarment& garment, std::vector<RunEvaluations> runs)
    : garment_(garment), search_(*garment.search), runs_(std::move(runs)) {
  for (const RunEvaluations& run : runs_) best_.push_back(best_so_far(run.error));
}

// The kept run comes last, so that it lies on top.
Chart SearchCharts::chart_of(const std::vector<Series>& tried) const {
  Chart chart;
  std::vector<ShownRun> shown = runs_to_show(search_);
  std::stable_partition(shown.begin(), shown.end(), [](const ShownRun& s) { return s.style > 0; });
  for (const ShownRun& s : shown) {
    ChartRun& run = chart.runs.emplace_back();
    run.number = s.index + 1;
    run.style = s.style;
    run.tried = tried[s.index];
    for (const std::size_t best : best_[s.index]) {
      run.found.push_back(best == kNone ? kNaN : run.tried[best]);
    }
  }
  return chart;
}

Panel SearchCharts::error() const {
  std::vector<Series> tried;
  for (const RunEvaluations& run : runs_) tried.push_back(run.error);
  Panel panel;
  panel.chart = chart_of(tried);
  panel.chart.width = kWideWidth;
  panel.chart.height = kWideHeight;
  panel.chart.range =
      range_showing(all_found(panel.chart), all_tried(panel.chart), kShownTries, AxisKind::Fitting);
  panel.title = "Error";
  panel.symbol = "<i>E</i>";
  panel.aside = panel.chart.range.logarithmic ? "logarithmic axis" : "";
  const ResultRun& kept = search_.runs[search_.kept - 1];
  panel.in_words = "The error over the evaluations of each run. The smallest, " +
                   significant_text(kept.error, 4) + ", was found by run " +
                   std::to_string(search_.kept) + " at its evaluation " +
                   std::to_string(kept.best) + ".";
  return panel;
}

Panel SearchCharts::term(const std::string& title, const std::string& symbol,
                         double ErrorTerms::*part) const {
  std::vector<Series> tried(runs_.size());
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    for (const ErrorTerms& terms : runs_[r].terms) {
      tried[r].push_back(contributions(terms, search_).*part);
    }
  }
  Panel panel;
  panel.title = title;
  panel.symbol = symbol;
  panel.chart = chart_of(tried);
  panel.aside = significant_text(contributions(search_.terms, search_).*part, 3) + " at the result";
  panel.in_words =
      "What this term adds to the error over the evaluations of each run: " + panel.aside + ".";
  return panel;
}

std::vector<Panel> SearchCharts::terms() const {
  const std::string off = "|1 − <i>E</i><sub>stretch</sub>|";
  std::vector<Panel> panels = {
      term("Distance", "α <i>E</i><sub>dist</sub>", &ErrorTerms::distance),
      term("Stretch", (search_.square_root ? "β √" : "β ") + off, &ErrorTerms::stretch),
      term("Silhouette", "γ <i>E</i><sub>sil</sub>", &ErrorTerms::silhouette)};
  std::vector<double> found = {0.0}, tried;
  for (const Panel& panel : panels) {
    const std::vector<double> lines = all_found(panel.chart), dots = all_tried(panel.chart);
    found.insert(found.end(), lines.begin(), lines.end());
    tried.insert(tried.end(), dots.begin(), dots.end());
  }
  AxisRange range = range_showing(found, tried, kShownTries);
  range.low = 0.0;
  for (Panel& panel : panels) panel.chart.range = range;
  return panels;
}

Panel SearchCharts::dimension(std::size_t d) const {
  const SearchedDimension& of = search_.dimensions[d];
  std::vector<Series> tried;
  for (const RunEvaluations& run : runs_) tried.push_back(run.dimensions_cm[d]);
  Panel panel;
  panel.chart = chart_of(tried);
  panel.title = of.name;
  panel.aside = "cm; bounds " + cm(of.lower_cm) + " to " + cm(of.upper_cm);
  panel.in_words = cm(search_.runs[search_.kept - 1].dimensions_cm[d]) + " cm at the result.";
  panel.chart.levels = {{of.lower_cm, "bound"}, {of.upper_cm, "bound"}};
  std::vector<double> always = all_found(panel.chart);
  for (const ResultMeasurement& m : garment_.measurements) {
    if (m.name != of.name) continue;
    panel.title = m.title;
    if (!m.truth_cm) continue;
    panel.chart.levels.push_back({*m.truth_cm, "truth"});
    panel.in_words += " The truth is " + cm(*m.truth_cm) + " cm.";
    always.push_back(*m.truth_cm);
  }
  panel.chart.range = range_showing(always, all_tried(panel.chart), kShownTries);
  return panel;
}

std::vector<Panel> SearchCharts::dimensions() const {
  std::vector<Panel> panels;
  for (std::size_t d = 0; d < search_.dimensions.size(); ++d) panels.push_back(dimension(d));
  return panels;
}

}  // namespace regarment
