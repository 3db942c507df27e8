#include "report/page.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "results.h"

namespace regarment {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::string page_of(const Result& result) { return report_page(result, bare_parts(result)); }

TEST(Page, LeavesNoGapUnfilled) {
  const std::string page = page_of(example_result());
  EXPECT_EQ(count(page, "{{"), 0u);
  EXPECT_EQ(count(page, "}}"), 0u);
}

TEST(Page, RequestsNothingAndForbidsScripts) {
  const std::string page = page_of(example_result());
  EXPECT_EQ(count(page, "default-src 'none'"), 1u);
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_EQ(count(page, "<link"), 0u);
  EXPECT_EQ(count(page, "@import"), 0u);
  EXPECT_EQ(count(page, "http://") + count(page, "https://"), 0u);
}

TEST(Page, EscapesEverythingFromOutside) {
  Result result = example_result();
  const std::string evil = "<script>alert(1)</script>\"'&{{title}}";
  result.scan.file = evil;
  result.warnings = {evil};
  result.scan.findings = {{"floor", Severity::Advice, evil, evil, evil}};
  result.command = evil;
  result.options = {{evil, evil}};
  result.landmarks_cm = {{evil, 1.0}};
  result.garments[0].title = evil;
  result.garments[0].template_name = evil;
  result.garments[0].measurements[0].title = evil;
  result.garments[0].measurements[0].how_to_measure = evil;
  result.garments[0].edges[0].evidence = evil;
  const std::string page = page_of(result);
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_GE(count(page, "&lt;script&gt;alert(1)&lt;/script&gt;&quot;&apos;&amp;"), 11u);
}

TEST(Page, SaysPassFailAndNotMeasurableInWords) {
  const std::string page = page_of(example_result());
  EXPECT_EQ(count(page, "✓ pass"), 1u);
  EXPECT_EQ(count(page, "✗ fail"), 1u);
  EXPECT_GE(count(page, "not measurable"), 1u);
}

TEST(Page, ShowsFindingsWithAWordForTheirSeverityTheWorstFirst) {
  Result result = example_result();
  result.scan.findings = {{"floor", Severity::Note, "A floor was seen", "It was left out", ""},
                          {"legs_touch", Severity::Problem, "The legs touch", "", "Scan again"}};
  const std::string page = page_of(result);
  const auto note = page.find("<b>Note.</b> A floor was seen. It was left out.</p>");
  const auto problem =
      page.find("<b>Problem.</b> The legs touch. <span class=\"advice\">Scan again");
  ASSERT_NE(note, std::string::npos);
  ASSERT_NE(problem, std::string::npos);
  EXPECT_LT(problem, note);
  EXPECT_EQ(count(page, "1 finding about the scan needs a look"), 1u);
}

TEST(Page, IsClearWithNotesOnly) {
  Result result = example_result();
  result.warnings.clear();
  result.garments[0].measurements.pop_back();  // the one that is not observable
  result.scan.findings = {{"floor", Severity::Note, "A floor was seen", "It was left out", ""}};
  EXPECT_EQ(count(page_of(result), "with remarks"), 0u);
  result.scan.findings[0].severity = Severity::Advice;
  EXPECT_EQ(count(page_of(result), "with remarks"), 1u);
}

TEST(Page, LeavesTruthColumnsOutWithoutTruth) {
  Result result = example_result();
  for (auto& m : result.garments[0].measurements) m.truth_cm.reset();
  const std::string page = page_of(result);
  EXPECT_EQ(count(page, ">Truth</th>"), 0u);
  EXPECT_EQ(count(page, ">Tolerance</th>"), 0u);
  EXPECT_EQ(count(page, ">Error</th>"), 0u);
}

TEST(Page, CountsWhatWasMeasuredAndWhatWasRight) {
  const std::string page = page_of(example_result());
  EXPECT_EQ(count(page, "3 of 4 dimensions measured"), 1u);
  // By hand: errors 0.3, 2.5 and 0.4 cm.
  EXPECT_EQ(count(page, "mean absolute error 1.1"), 1u);
  EXPECT_EQ(count(page, "Within tolerance: 1 of 2."), 1u);
}

TEST(Page, KeepsWhatWasGivenOutOfTheErrors) {
  Result result = example_result();
  result.garments[0].measurements[1].fixed = true;  // the width, 2.5 cm off
  const std::string page = page_of(result);
  EXPECT_EQ(count(page, "as given, held"), 1u);
  EXPECT_EQ(count(page, "mean absolute error 0.3"),
            1u);  // 0.35 of 0.3 and 0.4 lies just below, in binary
  EXPECT_EQ(count(page, "Within tolerance: 1 of 1."), 1u);
}

TEST(Page, SaysInWordsWhereAnEdgeMayAsWellLie) {
  const std::string page = page_of(example_result());
  EXPECT_EQ(count(page,
                  "may as well lie 4.2\u202fcm higher (weight 0.30), or 3.5\u202fcm lower "
                  "(weight 0.12); if so, give --hint skirt.waist_edge=105.8"),
            1u);
  EXPECT_EQ(count(page, "may as well lie"), 1u);  // the hem has one answer
}

TEST(Page, ShowsPicturesAsData) {
  Result result = example_result();
  PageParts parts = bare_parts(result);
  result.figures = {{"scan", "front", "pictures/scan-front.png", 3, 4}};
  EXPECT_THROW(report_page(result, parts), ReadError);
  parts.pictures["pictures/scan-front.png"] = "not a picture";
  EXPECT_THROW(report_page(result, parts), ReadError);
  parts.pictures["pictures/scan-front.png"] = "\x89PNG\r\n\x1a\n";
  const std::string page = report_page(result, parts);
  EXPECT_EQ(count(page, "src=\"data:image/png;base64,iVBORw0KGgo=\""),
            2u);  // and beside the verdict
}

TEST(Page, ShowsDrawingsAsPicturesThatCannotRun) {
  const Result result = example_result();
  PageParts parts = bare_parts(result);
  parts.drawings = {"<svg><script>alert(1)</script></svg>"};
  const std::string page = report_page(result, parts);
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_EQ(count(page, "src=\"data:image/svg+xml;base64,PHN2Zz48c2NyaXB0"), 1u);
  parts.drawings = {"alert(1)"};
  EXPECT_THROW(report_page(result, parts), ReadError);
}

TEST(Page, IsTheSameForTheSameResult) {
  const Result result = example_result();
  EXPECT_EQ(page_of(result), page_of(parse_result(result_json(result), "r")));
}

}  // namespace
}  // namespace regarment
