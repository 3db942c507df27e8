#include <algorithm>
#include <cmath>
#include <limits>

#include "report/chart.h"
#include "report/evaluations_csv.h"
#include "report/page_parts.h"
#include "report/search_charts.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string cm(double value_cm) { return cm_text(value_cm / 100.0); }

std::string error_text(double value) { return significant_text(value, 4); }

const ResultMeasurement* measurement_of(const ResultGarment& garment, const std::string& name) {
  for (const ResultMeasurement& m : garment.measurements) {
    if (m.name == name) return &m;
  }
  return nullptr;
}

std::string title_of(const ResultGarment& garment, const std::string& name) {
  const ResultMeasurement* m = measurement_of(garment, name);
  return m == nullptr ? name : m->title;
}

Gaps show_run(const ResultGarment& garment, const ShownRun& shown) {
  const ResultSearch& search = *garment.search;
  const ResultRun& run = search.runs[shown.index];
  Gaps row;
  row.set("run", std::to_string(shown.index + 1));
  row.set("style", std::to_string(shown.style));
  row.set("kept", shown.style == 0);
  row.set("ending", run.ending == FitEnding::Converged ? "converged" : "at its limit");
  row.set("evaluations", count_text(run.evaluations));
  row.set("unsettled", count_text(run.unsettled));
  row.set("error", error_text(run.error));
  std::vector<Gaps> lengths;
  for (std::size_t d = 0; d < search.dimensions.size(); ++d) {
    Gaps& cell = lengths.emplace_back();
    cell.set("name", title_of(garment, search.dimensions[d].name));
    cell.set("value", cm(run.dimensions_cm[d]));
  }
  row.set("lengths", std::move(lengths));
  return row;
}

Gaps show_panel(const Panel& panel, const std::string& id) {
  Gaps gaps;
  gaps.set("id", id);
  gaps.set("title", panel.title);
  gaps.set("symbol", panel.symbol);
  gaps.set_maybe("aside", panel.aside);
  gaps.set("in_words", panel.in_words);
  gaps.set("width", std::to_string(panel.chart.width));
  gaps.set("height", std::to_string(panel.chart.height));
  gaps.set("drawing", draw_chart(panel.chart));
  return gaps;
}

std::vector<Gaps> show_panels(const std::vector<Panel>& panels, const std::string& id) {
  std::vector<Gaps> out;
  for (const Panel& panel : panels) {
    out.push_back(show_panel(panel, id + "-" + std::to_string(out.size() + 1)));
  }
  return out;
}

void show_terms(const ResultSearch& search, Gaps& gaps) {
  // All with the digits of the sum, so that they can be seen to add up.
  const std::string sum = error_text(search.total);
  const auto point = sum.find('.');
  const int digits = point == std::string::npos ? 0 : static_cast<int>(sum.size() - point - 1);
  const ErrorTerms parts = contributions(search.terms, search);
  gaps.set("distance", fixed_text(search.terms.distance * 1000.0, 2));
  gaps.set("stretch", fixed_text(search.terms.stretch, 4));
  gaps.set("silhouette", significant_text(search.terms.silhouette, 3));
  gaps.set("alpha", significant_text(search.weights.alpha, 3));
  gaps.set("beta", significant_text(search.weights.beta, 3));
  gaps.set("gamma", significant_text(search.weights.gamma, 3));
  gaps.set("distance_part", fixed_text(parts.distance, digits));
  gaps.set("stretch_part", fixed_text(parts.stretch, digits));
  gaps.set("silhouette_part", fixed_text(parts.silhouette, digits));
  gaps.set("total", sum);
  gaps.set("square_root", search.square_root);
}

bool has_truth(const ResultGarment& garment) {
  return std::any_of(garment.search->dimensions.begin(), garment.search->dimensions.end(),
                     [&](const SearchedDimension& d) {
                       const ResultMeasurement* m = measurement_of(garment, d.name);
                       return m != nullptr && m->truth_cm;
                     });
}

void show_counts(const ResultSearch& search, std::size_t shown, Gaps& gaps) {
  std::size_t evaluations = 0, unsettled = 0;
  for (const ResultRun& run : search.runs) {
    evaluations += run.evaluations;
    unsettled += run.unsettled;
  }
  gaps.set("with_unsettled", unsettled > 0);
  gaps.set("evaluations", count_text(evaluations));
  gaps.set("runs_made", std::to_string(search.runs.size()));
  gaps.set("one_run", search.runs.size() == 1);
  gaps.set("kept_run", std::to_string(search.kept));
  gaps.set("some_shown", shown < search.runs.size());
  gaps.set("shown", std::to_string(shown));
}

Gaps show_search(const ResultGarment& garment, std::size_t number, const std::string& csv) {
  const ResultSearch& search = *garment.search;
  const std::string id = "search-" + std::to_string(number);
  const std::vector<ShownRun> shown = runs_to_show(search);
  const SearchCharts charts(
      garment, read_evaluations(csv, "evaluations-" + std::to_string(number) + ".csv", search));
  Gaps gaps;
  gaps.set("number", std::to_string(number));
  gaps.set("name", garment.title);
  gaps.set("layer", std::to_string(garment.layer));
  show_counts(search, shown.size(), gaps);
  show_terms(search, gaps);
  std::vector<Gaps> rows, columns;
  for (const ShownRun& run : shown) rows.push_back(show_run(garment, run));
  for (const SearchedDimension& dimension : search.dimensions) {
    columns.emplace_back().set("title", title_of(garment, dimension.name));
  }
  gaps.set("rows", std::move(rows));
  gaps.set("columns", std::move(columns));
  gaps.set("error_panel", show_panels({charts.error()}, id + "-error"));
  gaps.set("term_panels", show_panels(charts.terms(), id + "-term"));
  gaps.set("dimension_panels", show_panels(charts.dimensions(), id + "-dimension"));
  gaps.set("four", search.dimensions.size() == 4);
  gaps.set("with_truth", has_truth(garment));
  return gaps;
}

}  // namespace

void show_searches(const Result& result, const PageParts& parts, Gaps& page) {
  std::vector<Gaps> searches;
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    if (!result.garments[i].search) continue;
    searches.push_back(show_search(result.garments[i], i + 1, parts.evaluations[i]));
  }
  page.set("searches", std::move(searches));
}

}  // namespace regarment
