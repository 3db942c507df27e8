#include "evaluation/repeats.h"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluations.h"

namespace regarment {
namespace {

EvaluatedScan scan_of(const std::string& garment, const std::string& name,
                      const std::vector<double>& errors) {
  EvaluatedScan out = skirt_scan(name, errors);
  out.about.garment = garment;
  return out;
}

TEST(Repeats, PoolTheScansOfAGarment) {
  const auto repeats = repeated_dimensions(
      {scan_of("g", "g.mesh", {1, -2}), scan_of("h", "h.mesh", {5}), scan_of("g", "g.cloud", {3})});
  ASSERT_EQ(repeats.size(), 1u);  // the width is found once, h has one scan
  EXPECT_EQ(repeats[0].garment, "g");
  EXPECT_EQ(repeats[0].key, "skirt.length");
  EXPECT_EQ(repeats[0].scans, (std::vector<std::string>{"g.mesh", "g.cloud"}));
  EXPECT_NEAR(repeats[0].mean_error_cm, 2, 1e-9);
  EXPECT_NEAR(repeats[0].sd_cm, std::sqrt(2.0), 1e-9);  // errors 1 and 3
  EXPECT_NEAR(repeats[0].range_cm, 2, 1e-9);
}

TEST(Repeats, LeaveOutWhatIsHiddenFailedOrAnotherGarment) {
  EvaluatedScan hidden = scan_of("g", "a", {1});
  hidden.about.dimensions[0].observable = false;
  EvaluatedScan other = scan_of("g", "b", {1});
  other.about.dimensions[0].truth_cm = 60;
  EvaluatedScan broken = failed("c");
  broken.about.garment = "g";
  EXPECT_TRUE(repeated_dimensions({hidden, other, broken, scan_of("g", "d", {1})}).empty());
  EXPECT_TRUE(repeated_dimensions({skirt_scan("a", {1}), skirt_scan("b", {1})}).empty());
}

// By hand: g has errors 1, 3 (SD^2 = 2, mean 2), h -1, 0, 1 (SD^2 = 1, mean 0). Pooled variance
// (1 * 2 + 2 * 1) / 3; single errors 1 + 3 + 1 + 0 + 1 over 5; pooled (2 + 0) / 2.
TEST(Repeats, SumUpByMeasurement) {
  const auto summaries = repeat_summaries(
      repeated_dimensions({scan_of("g", "1", {1}), scan_of("g", "2", {3}), scan_of("h", "3", {-1}),
                           scan_of("h", "4", {0}), scan_of("h", "5", {1})}));
  ASSERT_EQ(summaries.size(), 1u);
  EXPECT_EQ(summaries[0].garments, 2u);
  EXPECT_EQ(summaries[0].scans, 5u);
  EXPECT_NEAR(summaries[0].within_sd_cm, std::sqrt(4.0 / 3), 1e-9);
  EXPECT_NEAR(summaries[0].single_mae_cm, 1.2, 1e-9);
  EXPECT_NEAR(summaries[0].pooled_mae_cm, 1, 1e-9);
}

TEST(Tolerance, IsTheUsualOneWhereNoneIsGiven) {
  const TrueDimension length = dimension("skirt", "length", 54);
  TrueDimension hip = dimension("skirt", "hip", 94);
  EXPECT_TRUE(length.tolerates(-1.0) && !length.tolerates(1.01));
  EXPECT_TRUE(hip.tolerates(1.3) && !hip.tolerates(-1.31));
  hip.tol_minus_cm = 2;  // and none above
  EXPECT_TRUE(hip.tolerates(-2) && hip.tolerates(0) && !hip.tolerates(0.1));
}

TEST(Tolerance, IsCountedInAGroup) {
  const auto groups = group_statistics({skirt_scan("a", {0.9, 1.2, 1.4, -5})});
  EXPECT_EQ(groups.front().in_tolerance, 2u);
}

}  // namespace
}  // namespace regarment
