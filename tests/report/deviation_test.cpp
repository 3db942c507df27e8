#include "report/deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "searches.h"

namespace regarment {
namespace {

const float kNone = std::nanf("");

// By hand: sorted -12, -3.9, -0.25, 0, 1, 10, 11 mm; the middle one is 0. Sizes sorted 0, 0.25,
// 1, 3.9, 10, 11, 12: 95 % of the way from the first to the last is 0.7 of the step from 11 to 12.
TEST(Deviation, IsCountedByHand) {
  const auto found = summarize_deviation(
      {0.010F, kNone, -0.012F, 0.0F, 0.001F, -0.00025F, kNone, 0.011F, -0.0039F}, 0.01);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->vertices, 7u);
  EXPECT_DOUBLE_EQ(found->median_mm, 0.0);
  EXPECT_NEAR(found->p95_mm, 11.7, 1e-3);
  EXPECT_DOUBLE_EQ(found->range_mm, 10.0);
  EXPECT_EQ(found->within, 4u);  // of -3.9, -0.25, 0 and 1 mm
  EXPECT_EQ(found->below, 1u);
  EXPECT_EQ(found->above, 1u);
  // Bins of half a millimetre from -10 mm: -3.9 lies in the 13th, 0 begins the 21st, 1 the 23rd.
  std::vector<std::size_t> counts(40, 0);
  counts[12] = counts[19] = counts[20] = counts[22] = counts[39] = 1;
  EXPECT_EQ(found->counts, counts);
}

TEST(Deviation, EveryVertexIsCountedOnce) {
  Random random(5);
  std::vector<float> values;
  for (int i = 0; i < 5000; ++i) values.push_back(static_cast<float>(0.004 * random.normal()));
  const auto found = summarize_deviation(values, deviation_range(values));
  const std::size_t within =
      std::accumulate(found->counts.begin(), found->counts.end(), std::size_t{0});
  EXPECT_EQ(found->below + within + found->above, 5000u);
  // Of a normal distribution: 95 % within 1.96 deviations.
  EXPECT_NEAR(found->p95_mm, 1.96 * 4.0, 0.3);
  EXPECT_NEAR(found->median_mm, 0.0, 0.3);
}

TEST(Deviation, OfNothingIsNothing) {
  EXPECT_FALSE(summarize_deviation({}, 0.01).has_value());
  EXPECT_FALSE(summarize_deviation({kNone, kNone}, 0.01).has_value());
  EXPECT_THROW(summarize_deviation({std::numeric_limits<float>::infinity()}, 0.01), InvalidInput);
}

TEST(Deviation, OfTheOutermostGarmentIsShown) {
  const GarmentTemplate skirt = find_template("skirt");
  Analysis analysis = column_analysis(skirt);
  EXPECT_TRUE(merged_deviation(analysis).empty());
  analysis.garments.push_back(analysis.garments.front());
  const std::size_t n = analysis.scan.mesh.positions.size();
  analysis.garments[1].deviation.assign(n, 0.002F);
  analysis.garments[0].deviation.assign(n, kNone);
  analysis.garments[0].deviation[3] = 0.001F;
  const std::vector<float> merged = merged_deviation(analysis);
  ASSERT_EQ(merged.size(), n);
  for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(merged[i], i == 3 ? 0.001F : 0.002F);
  analysis.garments[1].deviation.pop_back();
  EXPECT_THROW(merged_deviation(analysis), InvalidInput);
}

}  // namespace
}  // namespace regarment
