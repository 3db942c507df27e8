#include "evaluation/baseline.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "evaluation/evaluation_json.h"
#include "evaluations.h"

namespace regarment {
namespace {

Evaluation before() {
  return evaluation_of(
      {skirt_scan("a", {1, -1}), skirt_scan("b", {2, 2}), failed("c"), skirt_scan("d", {1, 1})});
}

int verdict(const BaselineComparison& comparison, const std::string& name) {
  for (const StatisticChange& change : comparison.statistics) {
    if (change.name == name) return change.verdict;
  }
  ADD_FAILURE() << name << " is not compared";
  return 9;
}

TEST(Baseline, OfItselfShowsNoChange) {
  const Evaluation now = before();
  const BaselineComparison same =
      compare_with(parse_baseline(evaluation_json(now), "old.json"), now);
  EXPECT_EQ(same.file, "old.json");
  EXPECT_TRUE(same.scans.empty());
  EXPECT_FALSE(same.statistics.empty());
  for (const StatisticChange& change : same.statistics) EXPECT_EQ(change.verdict, 0) << change.name;
}

TEST(Baseline, TellsBetterFromWorse) {
  const Evaluation now =
      evaluation_of({skirt_scan("a", {0.1, -0.1}), skirt_scan("b", {2, 5}), skirt_scan("c", {0, 0}),
                     failed("d"), skirt_scan("new", {1, 1})});
  const BaselineComparison change =
      compare_with(parse_baseline(evaluation_json(before()), "old.json"), now);
  EXPECT_EQ(verdict(change, "skirt.length.mae_cm"), 1);
  EXPECT_EQ(verdict(change, "skirt.width.worst_cm"), -1);
  EXPECT_EQ(verdict(change, "failures"), 0);
  ASSERT_EQ(change.scans.size(), 4u);
  // Failed before or now comes first, then the largest change.
  EXPECT_EQ(change.scans[0].name, "c");
  EXPECT_FALSE(change.scans[0].before_cm);
  EXPECT_EQ(change.scans[1].name, "d");
  EXPECT_FALSE(change.scans[1].now_cm);
  EXPECT_EQ(change.scans[2].name, "b");
  EXPECT_EQ(change.scans[3].name, "a");
  EXPECT_NEAR(change.scans[3].now_cm.value(), 0.1, 1e-9);
}

TEST(Baseline, RefusesWhatIsNoEvaluation) {
  for (const char* text : {"", "{}", "[]", R"({"schema": "regarment.result/1"})", "\xff"}) {
    EXPECT_THROW(parse_baseline(text, "old.json"), ReadError) << text;
  }
  std::string cut = evaluation_json(before());
  cut.resize(cut.size() / 2);
  EXPECT_THROW(parse_baseline(cut, "old.json"), ReadError);
}

}  // namespace
}  // namespace regarment
