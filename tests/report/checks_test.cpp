#include "report/checks.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "results.h"

namespace regarment {
namespace {

const Check& named(const std::vector<Check>& checks, const std::string& name) {
  for (const Check& check : checks) {
    if (check.name == name) return check;
  }
  throw InvalidInput("no check '" + name + "'");
}

CheckLevel level_of(const Result& result, const std::string& name) {
  return named(checks_of(result), name).level;
}

TEST(Checks, GoodOnesGiveNoAdviceAndTheOthersDo) {
  for (const Check& check : checks_of(example_result())) {
    EXPECT_EQ(check.advice.empty(), check.level == CheckLevel::Good) << check.name;
    EXPECT_FALSE(check.threshold.empty()) << check.name;
    EXPECT_FALSE(check.found.empty()) << check.name;
  }
}

TEST(Checks, CountWhatTheScanShows) {
  Result result = example_result();
  EXPECT_EQ(level_of(result, "Dimensions measured"), CheckLevel::Look);
  EXPECT_EQ(named(checks_of(result), "Dimensions measured").found, "3 of 4");
  result.garments[0].measurements[3].observable = true;
  EXPECT_EQ(level_of(result, "Dimensions measured"), CheckLevel::Good);
  for (int i = 0; i < 3; ++i) result.garments[0].measurements[i].observable = false;
  EXPECT_EQ(level_of(result, "Dimensions measured"), CheckLevel::Poor);
}

// Half widths 0.8, 1.5 and 1.2 cm: the middle one is 1.2.
TEST(Checks, CertaintyIsTheMiddleInterval) {
  Result result = example_result();
  EXPECT_EQ(named(checks_of(result), "Certainty").found,
            "half of the dimensions to \u00b11.2\u202fcm");
  auto& waist = result.garments[0].measurements[2];
  waist.low_cm = waist.value_cm - 4.0;
  waist.high_cm = waist.value_cm + 4.0;  // now 1.5 is in the middle, which is still good
  EXPECT_EQ(level_of(result, "Certainty"), CheckLevel::Good);
  auto& width = result.garments[0].measurements[1];
  width.low_cm = width.value_cm - 3.5;
  width.high_cm = width.value_cm + 3.5;
  EXPECT_EQ(level_of(result, "Certainty"), CheckLevel::Poor);
}

TEST(Checks, WithoutASpecificationNothingIsSaidOfIt) {
  Result result = example_result();
  EXPECT_EQ(level_of(result, "Against the specification"), CheckLevel::Look);
  auto& width = result.garments[0].measurements[1];
  width.low_cm = 112.1;  // 2.1 cm above, where 2 are allowed
  EXPECT_EQ(level_of(result, "Against the specification"), CheckLevel::Poor);
  for (auto& m : result.garments[0].measurements) m.truth_cm.reset();
  EXPECT_THROW(level_of(result, "Against the specification"), InvalidInput);
}

TEST(Checks, AnEdgeWithTwoPlacesNeedsALook) {
  Result result = example_result();
  EXPECT_EQ(level_of(result, "Skirt's edges"), CheckLevel::Look);
  result.garments[0].edges[0].rivals.clear();
  EXPECT_EQ(level_of(result, "Skirt's edges"), CheckLevel::Good);
  result.garments[0].edges[1].coverage = 0.49;
  EXPECT_EQ(level_of(result, "Skirt's edges"), CheckLevel::Poor);
}

TEST(Checks, StretchCountsEitherWay) {
  Result result = example_result();
  for (const double stretch : {0.98, 1.02}) {
    result.garments[0].mean_stretch = stretch;
    EXPECT_EQ(level_of(result, "Skirt's cloth"), CheckLevel::Good) << stretch;
  }
  for (const double stretch : {0.95, 1.05}) {
    result.garments[0].mean_stretch = stretch;
    EXPECT_EQ(level_of(result, "Skirt's cloth"), CheckLevel::Look) << stretch;
  }
  result.garments[0].mean_stretch = 1.1;
  EXPECT_EQ(level_of(result, "Skirt's cloth"), CheckLevel::Poor);
}

TEST(Checks, FindingsOfTheScanCountByTheirSeverity) {
  Result result = example_result();
  result.scan.findings = {{"floor", Severity::Note, "A floor was seen", "", ""}};
  EXPECT_EQ(level_of(result, "Scan"), CheckLevel::Good);
  result.scan.findings.push_back({"noisy", Severity::Advice, "The scan is noisy", "", ""});
  EXPECT_EQ(level_of(result, "Scan"), CheckLevel::Look);
  result.scan.findings.push_back({"legs_touch", Severity::Problem, "The legs touch", "", ""});
  EXPECT_EQ(level_of(result, "Scan"), CheckLevel::Poor);
  EXPECT_EQ(named(checks_of(result), "Scan").found, "2 findings need a look");
}

TEST(Checks, TheWorstDecides) {
  EXPECT_EQ(worst_level({}), CheckLevel::Good);
  Check look, poor;
  look.level = CheckLevel::Look;
  poor.level = CheckLevel::Poor;
  EXPECT_EQ(worst_level({Check(), look}), CheckLevel::Look);
  EXPECT_EQ(worst_level({look, poor, Check()}), CheckLevel::Poor);
}

}  // namespace
}  // namespace regarment
