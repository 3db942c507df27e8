#include "evaluation/iso_verdict.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

TEST(IsoLimit, DependsOnWhatIsMeasured) {
  EXPECT_EQ(iso_limit_cm(true, 94), 0.9);   // hip
  EXPECT_EQ(iso_limit_cm(true, 50), 0.9);   // the smallest large girth
  EXPECT_EQ(iso_limit_cm(true, 34), 0.4);   // sleeve opening
  EXPECT_EQ(iso_limit_cm(false, 60), 0.5);  // length
}

ErrorStatistics bias_between(double low, double high) {
  ErrorStatistics out;
  out.bias_low_cm = low, out.bias_high_cm = high;
  return out;
}

TEST(IsoVerdict, NeedsTheWholeIntervalWithin) {
  EXPECT_TRUE(iso_verdict(bias_between(-0.9, 0.9), 0.9)->within);
  EXPECT_FALSE(iso_verdict(bias_between(-0.91, 0.1), 0.9)->within);
  EXPECT_FALSE(iso_verdict(bias_between(-0.1, 0.91), 0.9)->within);
  EXPECT_FALSE(iso_verdict(bias_between(2, 3), 0.9)->within);
}

TEST(IsoVerdict, IsNotGivenOnOneSample) {
  EXPECT_FALSE(iso_verdict(error_statistics({{50, 50, {}, {}}}), 0.9));
}

}  // namespace
}  // namespace regarment
