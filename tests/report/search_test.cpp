#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "report/result_search.h"
#include "report/search_charts.h"
#include "searches.h"

namespace regarment {
namespace {

class Search : public testing::Test {
 protected:
  void SetUp() override { set_trace(tiny_trace(), garment_); }

  ResultSearch made() const { return make_search(garment_, skirt_); }
  void contradicts() const { EXPECT_THROW(made(), InvalidInput); }

  GarmentTemplate skirt_ = find_template("skirt");
  GarmentAnalysis garment_;
};

TEST_F(Search, IsToldInShort) {
  const ResultSearch search = made();
  ASSERT_EQ(search.runs.size(), 2u);
  EXPECT_EQ(search.runs[0].seed, 11u);
  EXPECT_EQ(search.runs[0].ending, FitEnding::Converged);
  EXPECT_EQ(search.runs[0].evaluations, 3u);
  EXPECT_EQ(search.runs[0].best, 2u);
  EXPECT_EQ(search.runs[0].unsettled, 1u);
  EXPECT_EQ(search.runs[0].error, 0.25);
  EXPECT_EQ(search.runs[0].dimensions_cm, std::vector<double>{60.0});
  EXPECT_EQ(search.kept, 2u);
  EXPECT_EQ(search.total, 0.125);
  EXPECT_EQ(search.dimensions.at(0).name, "length");
  EXPECT_DOUBLE_EQ(search.dimensions.at(0).upper_cm, skirt_.dimension("length").upper * 100.0);
}

// By hand: 2 x 0.25; 3 x sqrt(0.04) or 3 x 0.04; 5 x 0.5.
TEST_F(Search, TermsAreWeightedAsEquationOneHasThem) {
  ResultSearch search = made();
  search.weights = {2.0, 3.0, 5.0};
  search.square_root = true;
  const ErrorTerms with_root = contributions({0.25, 1.04, 0.5}, search);
  EXPECT_DOUBLE_EQ(with_root.distance, 0.5);
  EXPECT_NEAR(with_root.stretch, 0.6, 1e-12);
  EXPECT_DOUBLE_EQ(with_root.silhouette, 2.5);
  search.square_root = false;
  EXPECT_NEAR(contributions({0.25, 0.96, 0.5}, search).stretch, 0.12, 1e-12);
}

TEST_F(Search, ATraceThatContradictsItselfIsOurOwnMistake) {
  const auto with = [&](const auto& change) {
    set_trace(tiny_trace(), garment_);
    change(*garment_.trace);
    contradicts();
  };
  with([](FitTrace& t) { t.runs.clear(); });
  with([](FitTrace& t) { t.best_run = 2; });
  with([](FitTrace& t) { t.best_run = 0; });
  with([](FitTrace& t) { t.runs[0].best = 3; });
  with([](FitTrace& t) { t.runs[0].best = 0; });
  with([](FitTrace& t) { t.runs[1].best = 0; });  // has no error
  with([](FitTrace& t) { t.runs[0].evaluations.clear(); });
  with([](FitTrace& t) { t.runs[0].evaluations[0].dimensions.clear(); });
  with([](FitTrace& t) { t.runs[0].evaluations[0].dimensions = {std::nan("")}; });
  with([](FitTrace& t) { t.weights.beta = std::nan(""); });
  with([](FitTrace& t) { t.names = {"collar"}; });
}

TEST_F(Search, SixRunsAtMostAreShownTheKeptOneAndTheBest) {
  ResultSearch search;
  for (const double error : {0.9, 0.5, 0.1, 0.8, 0.2, 0.3, 0.4, 0.7}) {
    search.runs.emplace_back().error = error;
  }
  search.kept = 3;
  const std::vector<ShownRun> shown = runs_to_show(search);
  const std::vector<std::size_t> indices = {1, 2, 4, 5, 6, 7};
  const std::vector<int> styles = {1, 0, 2, 3, 4, 5};
  ASSERT_EQ(shown.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(shown[i].index, indices[i]);
    EXPECT_EQ(shown[i].style, styles[i]);
  }
}

class Charts : public Search {
 protected:
  SearchCharts charts(const ResultGarment& garment) const {
    return {garment, read_evaluations(evaluations_csv(*garment_.trace), "e", *garment.search)};
  }
  ResultGarment result() const {
    ResultGarment garment;
    garment.search = made();
    garment.measurements.resize(1);
    garment.measurements[0].name = "length";
    garment.measurements[0].title = "Length";
    garment.measurements[0].truth_cm = 47.0;
    return garment;
  }
};

TEST_F(Charts, LinesFollowTheSmallestErrorSoFar) {
  const ResultGarment garment = result();
  const Chart chart = charts(garment).error().chart;
  ASSERT_EQ(chart.runs.size(), 2u);
  EXPECT_EQ(chart.runs[0].number, 1u);
  EXPECT_EQ(chart.runs[0].tried, (std::vector<double>{0.5, 0.25, 0.375}));
  EXPECT_EQ(chart.runs[0].found, (std::vector<double>{0.5, 0.25, 0.25}));
  EXPECT_EQ(chart.runs[1].number, 2u);  // kept, and so on top
  EXPECT_EQ(chart.runs[1].style, 0);
  EXPECT_TRUE(std::isnan(chart.runs[1].found[0]));
  EXPECT_EQ(chart.runs[1].found[1], 0.125);
}

TEST_F(Charts, TheTermsOfALineAddUpToItsError) {
  set_trace(made_trace(skirt_, 3, 60), garment_);
  const ResultGarment garment = result();
  const SearchCharts all = charts(garment);
  const Chart error = all.error().chart;
  const std::vector<Panel> terms = all.terms();
  ASSERT_EQ(terms.size(), 3u);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t e = 0; e < error.runs[r].found.size(); ++e) {
      double sum = 0.0;
      for (const Panel& term : terms) sum += term.chart.runs[r].found[e];
      EXPECT_NEAR(sum / error.runs[r].found[e], 1.0, 1e-3);
    }
  }
  for (const Panel& term : terms) {
    EXPECT_EQ(term.chart.range.low, 0.0);
    EXPECT_EQ(term.chart.range.high, terms[0].chart.range.high);  // so that they can be compared
  }
}

TEST_F(Charts, DimensionsShowTheTruthAndWhatGaveTheSmallestError) {
  const ResultGarment garment = result();
  const std::vector<Panel> panels = charts(garment).dimensions();
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_EQ(panels[0].title, "Length");
  const Chart& chart = panels[0].chart;
  EXPECT_EQ(chart.runs[0].found, (std::vector<double>{50.0, 60.0, 60.0}));
  EXPECT_EQ(chart.levels.back().kind, "truth");
  EXPECT_EQ(chart.levels.back().value, 47.0);
  EXPECT_LT(chart.range.low, 45.0);
  EXPECT_GT(chart.range.high, 60.0);
}

}  // namespace
}  // namespace regarment
