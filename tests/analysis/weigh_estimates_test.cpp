#include "analysis/weigh_estimates.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

TEST(WeighEstimates, OfOneOpinionIsThatOpinion) {
  for (const DimensionRole role : {DimensionRole::BearingEdge, DimensionRole::TorsoEdge,
                                   DimensionRole::Hoop, DimensionRole::Length})
    EXPECT_NEAR(weigh({0.8, 0.8, 0.8, false}, role).value, 0.8, 1e-12);
}

TEST(WeighEstimates, LieBetweenTheirSourcesAndDoubtWhatLiesApart) {
  const WornEstimate agreed = weigh({0.8, 0.8, 0.8, false}, DimensionRole::Hoop);
  const WornEstimate apart = weigh({0.8, 0.84, 0.9, false}, DimensionRole::Hoop);
  EXPECT_GT(apart.value, 0.8);
  EXPECT_LT(apart.value, 0.9);
  EXPECT_GT(apart.standard_deviation, agreed.standard_deviation);
}

TEST(WeighEstimates, FollowClothThatHangsFreeAsFarAsItIsLoose) {
  const WornEstimate here{1.1, 0.01, 0};
  EXPECT_DOUBLE_EQ(weigh_free(here, {1.2, 0}).value, 1.1);
  EXPECT_DOUBLE_EQ(weigh_free(here, {1.2, 0}).standard_deviation, 0.01);
  EXPECT_NEAR(weigh_free(here, {1.2, 0.5}).value, 1.15, 1e-12);
  EXPECT_NEAR(weigh_free(here, {1.2, 1}).value, 1.2, 1e-12);
  EXPECT_GT(weigh_free(here, {1.2, 1}).standard_deviation, 0.02);
}

TEST(WeighEstimates, BelieveLongerClothMoreThanShorter) {
  const WornEstimate here{1.1, 0.01, 0};
  const double longer = weigh_free(here, {1.2, 1}).value - 1.1;
  const double shorter = 1.1 - weigh_free(here, {1.0, 1}).value;
  EXPECT_GT(shorter, 0);
  EXPECT_LT(shorter, longer);
}

}  // namespace
}  // namespace regarment
