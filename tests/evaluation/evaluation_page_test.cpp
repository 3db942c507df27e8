#include "evaluation/evaluation_page.h"

#include <gtest/gtest.h>

#include "evaluation/baseline.h"
#include "evaluation/evaluation_csv.h"
#include "evaluation/evaluation_json.h"
#include "evaluations.h"
#include "report/csv_table.h"
#include "report/json_schema.h"

namespace regarment {
namespace {

Evaluation everything() {
  Evaluation out =
      evaluation_of({skirt_scan("a", {1, -1, 0.5, 2}), skirt_scan("b", {4, 2, 8, 1}), failed("c")});
  out.scans[0].labels = LabelAgreement{0.9, {{"person", 0.95}, {"skirt", 0.85}}, 4.0};
  out.scans[0].about.dimensions[0].published_cm = 55;
  out.scans[0].report = "fits/a/report.html";
  out.groups = group_statistics(out.scans);
  out.gates = {{"mae_cm<=1", 2.4, false}, {"failures<=3", 1.0, true}, {"coverage>1", {}, false}};
  out.baseline = compare_with(
      parse_baseline(evaluation_json(evaluation_of({skirt_scan("a", {2, 2})})), "old.json"), out);
  out.pictures = {{0, "RIFFpicture", 470, 400}};
  return out;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(EvaluationJson, IsValidByItsSchema) {
  const auto check = [](const Evaluation& evaluation) {
    check_by_schema(evaluation_json(evaluation), "evaluation.schema.json", "e.json", "");
  };
  EXPECT_NO_THROW(check(everything()));
  EXPECT_NO_THROW(check(evaluation_of({failed("a")})));
}

TEST(EvaluationJson, KeepsBytesThatAreNoText) {
  Evaluation evaluation = evaluation_of({failed("a\xff")});
  EXPECT_NO_THROW(
      check_by_schema(evaluation_json(evaluation), "evaluation.schema.json", "e.json", ""));
}

TEST(EvaluationCsv, HasARowForEachDimension) {
  const CsvTable table = CsvTable::parse(evaluation_csv(everything()), "e.csv");
  ASSERT_EQ(table.size(), 4u + 4u + 2u);
  EXPECT_EQ(table.number(0, "error_cm"), 1.0);
  EXPECT_EQ(table.cell(1, "measurement"), "width");
  EXPECT_EQ(table.number(1, "estimate_cm"), 109.0);
  EXPECT_EQ(table.cell(9, "estimate_cm"), "");
  EXPECT_EQ(table.cell(9, "failure"), "crash");
}

TEST(EvaluationCsv, DisarmsFormulas) {
  Evaluation evaluation = evaluation_of({failed("=1+1")});
  EXPECT_EQ(CsvTable::parse(evaluation_csv(evaluation), "e.csv").cell(0, "scan"), "'=1+1");
}

TEST(EvaluationPage, RequestsNothing) {
  const std::string page = evaluation_page(everything());
  for (const char* word : {"http://", "https://", "<link", "@import", "url(", "style=\""}) {
    EXPECT_FALSE(has(page, word)) << word;
  }
  EXPECT_TRUE(has(page, "default-src &apos;none&apos;"));
  EXPECT_FALSE(has(page, "unsafe"));
}

TEST(EvaluationPage, FillsEveryGap) { EXPECT_FALSE(has(evaluation_page(everything()), "{{")); }

TEST(EvaluationPage, ShowsTheWorstScanFirstAndItsPicture) {
  const Evaluation evaluation = everything();
  EXPECT_EQ(worst_scans(evaluation), (std::vector<std::size_t>{1, 0}));
  const std::string page = evaluation_page(evaluation);
  EXPECT_TRUE(has(page, "data:image/webp;base64,"));
  EXPECT_TRUE(has(page, "fits/a/report.html"));
  EXPECT_FALSE(has(page, "fits/b/report.html"));
}

TEST(EvaluationPage, ShowsAtMostTwelve) {
  std::vector<EvaluatedScan> scans;
  scans.reserve(30);
  for (int i = 0; i < 30; ++i) scans.push_back(skirt_scan("s" + std::to_string(i), {0.1 * i}));
  const std::vector<std::size_t> worst = worst_scans(evaluation_of(scans));
  ASSERT_EQ(worst.size(), 12u);
  EXPECT_EQ(worst.front(), 29u);
  EXPECT_EQ(worst.back(), 18u);
}

std::size_t position(const std::string& text, const std::string& part) { return text.find(part); }

// b is 8 cm off in its waist, a 2 cm in its hip; c failed.
TEST(EvaluationPage, ListsEveryDimensionTheWorstFirst) {
  const std::string page = evaluation_page(everything());
  const std::string table = page.substr(position(page, "id=\"dimensions\""));
  const std::size_t first = position(table, ">+8.0<"), last = position(table, ">+0.5<");
  EXPECT_LT(first, position(table, ">+2.0<"));
  EXPECT_LT(position(table, ">+2.0<"), last);
  EXPECT_NE(last, std::string::npos);
}

TEST(EvaluationPage, PoolsScansOfOneGarment) {
  Evaluation evaluation = everything();
  EXPECT_FALSE(has(evaluation_page(evaluation), "id=\"repeats\""));
  evaluation.scans[0].about.garment = evaluation.scans[1].about.garment = "g<1>";
  const std::string page = evaluation_page(evaluation);
  EXPECT_TRUE(has(page, "id=\"repeats\""));
  EXPECT_TRUE(has(page, "a +1.0, b +4.0"));
  EXPECT_TRUE(has(page, "g&lt;1&gt;"));
  EXPECT_NO_THROW(
      check_by_schema(evaluation_json(evaluation), "evaluation.schema.json", "e.json", ""));
}

TEST(EvaluationPage, SaysWhatFailed) {
  const std::string page = evaluation_page(everything());
  EXPECT_TRUE(has(page, "2 gates of 3 failed"));
  EXPECT_TRUE(has(page, "ended by signal 11"));
  EXPECT_TRUE(has(page, "old.json"));
}

TEST(EvaluationPage, EscapesWhatComesFromOutside) {
  Evaluation evaluation = everything();
  evaluation.table = "<b>&.csv";
  evaluation.scans[2].failure->line = "<script>alert(1)</script>";
  evaluation.scans[0].about.damage = {"<i>"};
  const std::string page = evaluation_page(evaluation);
  EXPECT_FALSE(has(page, "<b>&"));
  EXPECT_FALSE(has(page, "<script>alert"));
  EXPECT_FALSE(has(page, "<i>,"));
}

TEST(EvaluationPage, StandsAnEvaluationOfNothing) {
  const std::string page = evaluation_page(evaluation_of({failed("a")}));
  EXPECT_TRUE(has(page, "Nothing could be measured"));
  EXPECT_FALSE(has(page, "nan"));
}

}  // namespace
}  // namespace regarment
