#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/evaluations_csv.h"
#include "results.h"
#include "searches.h"
#include "support/texts.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

/// A result whose garment was searched for, with deviations.
class PageSearch : public testing::Test {
 protected:
  PageSearch() {
    use(tiny_trace());
    result_.garments[0].deviation = ResultDeviation{10, 0.5, 4.0, 3.0, 7, 5.0, 1, {2, 3, 4}, 0};
    result_.figures = {{"deviation", "front", "pictures/deviation-front.png", 3, 4}};
  }

  void use(const FitTrace& trace) {
    GarmentAnalysis garment;
    set_trace(trace, garment);
    result_.garments[0].search = make_search(garment, find_template("skirt"));
    parts_ = bare_parts(result_);
    parts_.evaluations[0] = evaluations_csv(trace);
    parts_.pictures["pictures/deviation-front.png"] = "\x89PNG\r\n\x1a\n";
  }
  std::string page() const { return report_page(result_, parts_); }
  Json json() const { return Json::parse(result_json(result_)); }

  Result result_ = example_result();
  PageParts parts_;
};

TEST_F(PageSearch, ResultJsonHoldsWhatTheContractNames) {
  const Json garment = json().at("garments").at(0);
  EXPECT_EQ(garment.at("error").at("total"), 0.125);
  EXPECT_EQ(garment.at("error").at("silhouette"), 0.0625);
  EXPECT_EQ(garment.at("search").at("weights").at("gamma"), 1.0);
  EXPECT_EQ(garment.at("search").at("kept_run"), 2);
  const Json& run = garment.at("runs").at(0);
  EXPECT_EQ(run.at("ending"), "converged");
  EXPECT_EQ(run.at("evaluations"), 3);
  EXPECT_EQ(run.at("error"), 0.25);
  EXPECT_EQ(run.at("seed"), 11);
  EXPECT_EQ(run.at("dimensions_cm").at("length"), 60.0);
  EXPECT_EQ(garment.at("runs").at(1).at("ending"), "evaluation_limit");
  EXPECT_EQ(garment.at("deviation").at("histogram").at("counts"), Json({2, 3, 4}));
}

TEST_F(PageSearch, ResultJsonComesBackTheSame) {
  // As `make_result` leaves them: the terms of a search are those of the garment.
  result_.garments[0].mean_distance_m = result_.garments[0].search->terms.distance;
  result_.garments[0].mean_stretch = result_.garments[0].search->terms.stretch;
  result_.garments[0].silhouette.reset();
  const std::string text = result_json(result_);
  const Result back = parse_result(text, "r");
  EXPECT_EQ(result_json(back), text);
  EXPECT_EQ(report_page(back, parts_), page());
}

TEST_F(PageSearch, WithoutASearchNothingIsSaidOfOne) {
  result_.garments[0].search.reset();
  result_.garments[0].deviation.reset();
  const Json garment = json().at("garments").at(0);
  EXPECT_TRUE(garment.at("error").at("total").is_null());
  EXPECT_EQ(garment.at("error").at("silhouette"), 5.25);
  EXPECT_TRUE(garment.at("runs").empty());
  EXPECT_FALSE(garment.contains("search"));
  EXPECT_FALSE(garment.contains("deviation"));
  EXPECT_EQ(count(page(), "id=\"search-1\""), 0u);
  EXPECT_EQ(count(page(), "class=\"legend\""), 0u);
}

TEST_F(PageSearch, LeavesNoGapUnfilledAndRequestsNothing) {
  use(made_trace(find_template("skirt"), 3, 500));
  const std::string text = without_sizes(page());
  EXPECT_EQ(count(text, "{{") + count(text, "}}"), 0u);
  EXPECT_EQ(count(text, "<link") + count(text, "@import"), 0u);
  EXPECT_EQ(count(text, "http://") + count(text, "https://"), 0u);
  EXPECT_EQ(count(text, "url("), count(text, "url(#"));
}

TEST_F(PageSearch, EachDrawingHasATitleAndWords) {
  use(made_trace(find_template("skirt"), 3, 50));
  const std::string text = page();
  // Error, three terms, four dimensions, and the legend of the deviation.
  EXPECT_EQ(count(text, "<svg class=\"chart\""), 9u);
  EXPECT_EQ(count(text, "<desc "), 9u);
  EXPECT_EQ(count(text, "role=\"img\" aria-labelledby=\"search-1-"), 8u);
  for (const char* id : {"search-1-error-1", "search-1-term-3", "search-1-dimension-4"}) {
    EXPECT_EQ(count(text, std::string("<title id=\"") + id + "-title\""), 1u) << id;
    EXPECT_EQ(count(text, std::string("<desc id=\"") + id + "-words\""), 1u) << id;
  }
}

TEST_F(PageSearch, ShowsTheBandOfAGoodFitInTheHistogram) {
  EXPECT_EQ(count(page(), "<rect class=\"band\""), 1u);
  EXPECT_EQ(count(page(), "70.0&nbsp;% within the ±3&nbsp;mm a good fit keeps (pale band)"), 1u);
  result_.garments[0].deviation->band_mm = 5.0;  // as wide as the scale: nothing to draw
  EXPECT_EQ(count(page(), "<rect class=\"band\""), 0u);
  EXPECT_EQ(count(page(), "(pale band)"), 0u);
}

TEST_F(PageSearch, TellsTheRunsAndWhichWasKept) {
  const std::string text = page();
  EXPECT_EQ(count(text, "Run 2 <span class=\"tag\">kept</span>"), 1u);
  EXPECT_EQ(count(text, "data-name=\"Ended\">converged<"), 1u);
  EXPECT_EQ(count(text, "data-name=\"Ended\">at its limit<"), 1u);
  EXPECT_EQ(count(text, "Each spring counts once"), 1u);
  EXPECT_EQ(count(text, "data-name=\"Adds\">0.0625<"), 2u);  // what distance and silhouette add
  EXPECT_EQ(count(text, "√|1"), 0u);                         // this search left the root out
}

TEST_F(PageSearch, ASearchTakesLittleRoom) {
  use(made_trace(find_template("skirt"), 3, 500));
  const std::string with = page();
  result_.garments[0].search.reset();
  EXPECT_LT(with.size() - page().size(), 150'000u);
}

TEST_F(PageSearch, EscapesTitles) {
  result_.garments[0].title = "<script>";
  result_.garments[0].measurements[0].title = "<script>";
  EXPECT_EQ(count(page(), "<script"), 2u);  // the page's own, and its data
}

// Each change breaks what the file says of its search.
TEST_F(PageSearch, ResultsThatContradictThemselvesAreRefused) {
  const Json good = json();
  parse_result(good.dump(), "r");
  const auto refuses = [&](const auto& change) {
    Json bad = good;
    change(bad["garments"][0]);
    EXPECT_THROW(parse_result(bad.dump(), "r"), ReadError) << bad["garments"][0].dump();
  };
  refuses([](Json& g) { g["runs"] = Json::array(); });
  refuses([](Json& g) { g.erase("search"); });
  refuses([](Json& g) { g["search"]["kept_run"] = 3; });
  refuses([](Json& g) { g["search"]["kept_run"] = 0; });
  refuses([](Json& g) { g["search"]["dimensions"][0]["name"] = "waist"; });
  refuses([](Json& g) { g["search"]["dimensions"][0]["name"] = "../x,y"; });
  refuses([](Json& g) { g["search"]["weights"]["alpha"] = nullptr; });
  refuses([](Json& g) { g["search"]["weights"]["alpha"] = 1e300; });
  refuses([](Json& g) { g["runs"][0]["best_evaluation"] = 4; });
  refuses([](Json& g) { g["runs"][0]["best_evaluation"] = 0; });
  refuses([](Json& g) { g["runs"][0]["evaluations"] = 1'000'000'000'000; });
  refuses([](Json& g) { g["runs"][0]["evaluations"] = -1; });
  refuses([](Json& g) { g["runs"][0]["unsettled"] = 4; });
  refuses([](Json& g) { g["runs"][0]["dimensions_cm"]["waist"] = 4; });
  refuses([](Json& g) { g["runs"][0]["dimensions_cm"].clear(); });
  refuses([](Json& g) { g["runs"][0]["ending"] = "tired"; });
  refuses([](Json& g) { g["error"]["total"] = nullptr; });
  refuses([](Json& g) { g["deviation"]["vertices"] = 11; });
  refuses([](Json& g) { g["deviation"]["within_band"] = 11; });
  refuses([](Json& g) { g["deviation"]["range_mm"] = 0; });
  refuses([](Json& g) { g["deviation"]["histogram"]["counts"] = Json::array(); });
  refuses([](Json& g) { g["deviation"]["histogram"]["counts"][0] = -2; });
  refuses([](Json& g) { g["deviation"]["histogram"]["counts"] = std::vector<int>(100'000, 1); });
  refuses([](Json& g) { g["deviation"]["median_mm"] = nullptr; });
}

TEST_F(PageSearch, EvaluationsOfAnotherSearchAreRefused) {
  parts_.evaluations[0].clear();
  EXPECT_THROW(page(), ReadError);
  parts_.evaluations[0] = evaluations_csv(made_trace(find_template("skirt"), 2, 20));
  EXPECT_THROW(page(), ReadError);
}

}  // namespace
}  // namespace regarment
