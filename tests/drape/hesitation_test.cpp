#include "drape/hesitation.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

std::vector<Attraction> pulled_to(const Vec3& target, bool pulls = true) {
  Attraction a;
  a.target = target;
  a.found = true;
  a.pulls = pulls;
  return {a};
}

TEST(Hesitation, TrustsATargetThatMovesAlong) {
  Hesitation hesitation({Vec3::Zero()}, pulled_to(Vec3(0, 0, 0.01)));
  for (int step = 1; step <= 20; ++step) {
    std::vector<Attraction> targets = pulled_to(Vec3(0.02 * step, 0, 0.01));
    hesitation.weigh({Vec3(0.01 * step, 0, 0)}, targets);
    EXPECT_EQ(targets[0].weight, 1) << step;
  }
}

TEST(Hesitation, HalvesThePullOfEachJumpButTheFirst) {
  Hesitation hesitation({Vec3::Zero()}, pulled_to(Vec3(0, 0, 0.05)));
  double expected = 1;
  for (int step = 1; step <= 6; ++step) {
    std::vector<Attraction> targets = pulled_to(Vec3(0, 0, step % 2 == 0 ? 0.05 : -0.05));
    EXPECT_EQ(hesitation.any_side()[0], step > 1 ? 1 : 0) << step;
    hesitation.weigh({Vec3::Zero()}, targets);
    if (step > 1) expected /= 2;
    EXPECT_EQ(targets[0].weight, expected) << step;
  }
}

TEST(Hesitation, CountsComingAndGoingOfThePull) {
  Hesitation hesitation({Vec3::Zero()}, pulled_to(Vec3(0, 0, 0.01)));
  const auto weight_when = [&](bool pulls) {
    std::vector<Attraction> targets = pulled_to(Vec3(0, 0, 0.01), pulls);
    hesitation.weigh({Vec3::Zero()}, targets);
    return targets[0].weight;
  };
  EXPECT_EQ(weight_when(false), 1);
  EXPECT_EQ(weight_when(false), 1);
  EXPECT_EQ(weight_when(true), 0.5);
  EXPECT_EQ(weight_when(true), 0.5);
  EXPECT_EQ(weight_when(false), 0.25);
}

TEST(Hesitation, ForgivesTurningBackOnlyAtFirst) {
  Hesitation hesitation({Vec3::Zero()}, pulled_to(Vec3(0, 0, 0.01)));
  std::vector<Attraction> targets;
  for (int step = 1; step <= 6; ++step) {
    targets = pulled_to(Vec3(0, 0, 0.01));
    hesitation.weigh({Vec3(0, 0, step % 2 == 0 ? 0 : 0.004)}, targets);
    EXPECT_EQ(targets[0].weight, step <= 5 ? 1 : 0.5) << step;
  }
}

TEST(Hesitation, ForgivesTrembling) {
  Hesitation hesitation({Vec3::Zero()}, pulled_to(Vec3(0, 0, 0.01)));
  for (int step = 1; step <= 20; ++step) {
    std::vector<Attraction> targets = pulled_to(Vec3(0, 0, 0.01));
    hesitation.weigh({Vec3(0, 0, step % 2 == 0 ? 0 : 0.001)}, targets);
    EXPECT_EQ(targets[0].weight, 1) << step;
  }
}

}  // namespace
}  // namespace regarment
