#include "report/judgement.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

ResultMeasurement waist(double value, double low, double high) {
  ResultMeasurement m;
  m.circumference = true;
  m.value_cm = value;
  m.low_cm = low;
  m.high_cm = high;
  m.truth_cm = 78.0;
  m.tol_minus_cm = 0.5;
  m.tol_plus_cm = 1.0;
  return m;
}

TEST(Judgement, ComparesTheValueAndItsIntervalWithTheLimits) {
  EXPECT_EQ(judge(waist(78.0, 77.5, 79.0)), Judgement::Pass);  // the limits themselves are inside
  EXPECT_EQ(judge(waist(78.0, 77.4, 78.5)), Judgement::LikelyPass);
  EXPECT_EQ(judge(waist(78.9, 78.0, 79.1)), Judgement::LikelyPass);
  EXPECT_EQ(judge(waist(77.4, 76.0, 77.5)), Judgement::LikelyFail);
  EXPECT_EQ(judge(waist(79.1, 79.0, 80.0)), Judgement::LikelyFail);
  EXPECT_EQ(judge(waist(77.0, 76.0, 77.4)), Judgement::Fail);
  EXPECT_EQ(judge(waist(80.0, 79.1, 81.0)), Judgement::Fail);
}

TEST(Judgement, IsNotPassedOnWhatWasNotMeasured) {
  ResultMeasurement m = waist(78.0, 77.9, 78.1);
  m.observable = false;
  EXPECT_EQ(judge(m), Judgement::NotMeasurable);
  m.observable = true;
  m.fixed = true;
  EXPECT_EQ(judge(m), Judgement::NotJudged);
  m.fixed = false;
  m.truth_cm.reset();
  EXPECT_EQ(judge(m), Judgement::NotJudged);
}

TEST(Judgement, AMissingSideOfAToleranceAllowsNothing) {
  ResultMeasurement m = waist(77.9, 77.8, 77.95);
  m.tol_minus_cm.reset();
  EXPECT_EQ(judge(m), Judgement::Fail);
  EXPECT_DOUBLE_EQ(tolerance_of(m).minus_cm, 0.0);
  EXPECT_TRUE(tolerance_of(m).given);
}

TEST(Judgement, WithoutAToleranceTheUsualOneCounts) {
  ResultMeasurement m = waist(79.2, 79.1, 79.3);
  m.tol_minus_cm.reset();
  m.tol_plus_cm.reset();
  EXPECT_EQ(judge(m), Judgement::Pass);  // half an inch of a circumference
  EXPECT_FALSE(tolerance_of(m).given);
  m.circumference = false;
  EXPECT_EQ(judge(m), Judgement::Fail);  // but not of a length
}

}  // namespace
}  // namespace regarment
