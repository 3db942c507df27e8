#include "fabric/level_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace regarment {
namespace {

// Points of a closed curve in a slanting plane, radius by angle.
template <typename Radius>
std::vector<Vec3> ring(const Radius& radius) {
  const Vec3 u(1, 0, 0), v = Vec3(0, 1, 2).normalized();
  std::vector<Vec3> out;
  for (int k = 0; k < 720; ++k) {
    const double angle = k * std::numbers::pi / 360;
    out.push_back(radius(angle) * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return out;
}

TEST(TapeLength, IsTheLengthOfAConvexRing) {
  const double tape = tape_length(ring([](double) { return 0.15; }));
  EXPECT_NEAR(tape, 0.3 * std::numbers::pi, 1e-5);  // m, of a polygon of 720 sides
}

TEST(TapeLength, BridgesFolds) {
  // A fold inwards: a tape goes straight across the gap between 40 and 50 degrees.
  const auto folded = ring([](double angle) {
    const double degrees = angle * 180 / std::numbers::pi;
    return degrees > 40 && degrees < 50 ? 0.1 : 0.15;
  });
  const double gap = std::numbers::pi / 18;
  const double bridged = 0.15 * (2 * std::numbers::pi - gap) + 2 * 0.15 * std::sin(gap / 2);
  EXPECT_NEAR(tape_length(folded), bridged, 1e-5);
}

TEST(TapeLength, IsNothingOfTwoPointsOrALine) {
  EXPECT_EQ(tape_length({Vec3(0, 0, 0), Vec3(1, 0, 0)}), 0);
  EXPECT_EQ(tape_length({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(3, 0, 0)}), 0);
  EXPECT_EQ(tape_length(std::vector<Vec3>(5, Vec3(1, 2, 3))), 0);
}

}  // namespace
}  // namespace regarment
