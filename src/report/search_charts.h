#pragma once

#include <string>
#include <vector>

#include "report/chart.h"
#include "report/evaluations_csv.h"
#include "report/result.h"

namespace regarment {

/// A run that is drawn, and how.
struct ShownRun {
  std::size_t index = 0;  // into ResultSearch::runs
  int style = 0;          // 0: the kept run
};

/// The kept run and those with the next smallest errors, six in all, in their order.
std::vector<ShownRun> runs_to_show(const ResultSearch& search);

/// A chart and the words around it.
struct Panel {
  std::string title;     // may come from outside
  std::string symbol;    // HTML, of our own
  std::string aside;     // a few words beside the title
  std::string in_words;  // for those who do not see the chart
  Chart chart;
};

/// The charts of one search: what was tried as dots, the best so far as lines.
class SearchCharts {
 public:
  /// `garment` was searched for, and outlives this.
  SearchCharts(const ResultGarment& garment, std::vector<RunEvaluations> runs);

  Panel error() const;
  std::vector<Panel> terms() const;       // weighted, on one axis, so that they can be compared
  std::vector<Panel> dimensions() const;  // cm

 private:
  using Series = std::vector<double>;
  Chart chart_of(const std::vector<Series>& tried) const;
  Panel term(const std::string& title, const std::string& symbol, double ErrorTerms::*part) const;
  Panel dimension(std::size_t d) const;

  const ResultGarment& garment_;
  const ResultSearch& search_;
  std::vector<RunEvaluations> runs_;
  std::vector<std::vector<std::size_t>> best_;  // per run: the best evaluation so far, or kNone
};

}  // namespace regarment
