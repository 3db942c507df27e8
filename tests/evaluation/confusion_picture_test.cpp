#include "evaluation/confusion_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regarment {
namespace {

TEST(Confusion, FollowsLabelAndTruth) {
  EXPECT_EQ(confusion_of(0, 0), Confusion::RightPerson);
  EXPECT_EQ(confusion_of(1, 1), Confusion::RightGarment);
  EXPECT_EQ(confusion_of(0, 1), Confusion::Missed);
  EXPECT_EQ(confusion_of(1, 0), Confusion::Wrong);
  EXPECT_EQ(confusion_of(2, 1), Confusion::Wrong);
  EXPECT_EQ(confusion_of(1, 255), Confusion::NotScored);
}

using Linear = std::array<double, 3>;

Linear linear(Colour colour) {
  Linear out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = std::pow(colour[i] / 255.0, 2.2);
  return out;
}

// As people without one kind of cone see it [Viénot, Brettel and Mollon 1999], linear light.
Linear without_red_cones(const Linear& c) {
  const double mixed = 0.11238 * c[0] + 0.88762 * c[1];
  return {mixed, mixed, 0.00401 * c[0] - 0.00401 * c[1] + c[2]};
}
Linear without_green_cones(const Linear& c) {
  const double mixed = 0.29275 * c[0] + 0.70725 * c[1];
  return {mixed, mixed, -0.02234 * c[0] + 0.02234 * c[1] + c[2]};
}

double apart(const Linear& a, const Linear& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d =
        std::pow(std::max(a[i], 0.0), 1 / 2.2) - std::pow(std::max(b[i], 0.0), 1 / 2.2);
    sum += d * d;
  }
  return std::sqrt(sum);
}

TEST(Confusion, ColoursAreToldApartByEveryone) {
  const std::vector<Confusion> all = {Confusion::RightPerson, Confusion::RightGarment,
                                      Confusion::Missed, Confusion::Wrong, Confusion::NotScored};
  // A tenth of the way from black to white in every channel.
  const double enough = 0.1 * std::sqrt(3.0);
  for (const Confusion a : all) {
    for (const Confusion b : all) {
      if (a == b) continue;
      const Linear one = linear(confusion_colour(a)), other = linear(confusion_colour(b));
      EXPECT_GT(apart(one, other), enough);
      EXPECT_GT(apart(without_red_cones(one), without_red_cones(other)), enough);
      EXPECT_GT(apart(without_green_cones(one), without_green_cones(other)), enough);
    }
  }
}

}  // namespace
}  // namespace regarment
