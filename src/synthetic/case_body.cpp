#include "synthetic/case_body.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace regarment {
namespace {

// Shares of the library's bodies: four women, then four men.
std::array<double, 8> sample_blend(bool female, CaseDice& dice) {
  std::array<double, 8> out{};
  const std::size_t first = female ? 0 : 4;
  double sum = 0;
  for (std::size_t i = first; i < first + 4; ++i) {
    // An exponential each and one left out: mixtures spread evenly over all there are.
    out[i] = -std::log(1 - dice.uniform(0, 1));
  }
  out[first + static_cast<std::size_t>(dice.uniform(0, 4))] = 0;
  for (const double share : out) sum += share;
  for (double& share : out) share /= sum;
  return out;
}

void sample_build(CaseDice& dice, BodyShape& shape) {
  const bool heavy = dice.share(CaseChoice::Build) < 0.25;
  const auto grown = [&](double low, double high) {
    return heavy ? dice.uniform(0.3 * high, high) : dice.about(0, -low / 2);
  };
  shape.belly = grown(-0.08, 0.2);
  shape.chest = grown(-0.05, 0.12);
  shape.hips = grown(-0.06, 0.16);
  shape.thighs = grown(-0.06, 0.13);
  shape.arms = grown(-0.08, 0.14);
  shape.shoulders = dice.uniform(-0.012, 0.025);
  shape.asymmetry = dice.about(0, 0.1);
  shape.scale = dice.about(1.0, 0.04);
}

void sample_pose(bool skirt, CaseDice& dice, BodyShape& shape) {
  const double arms = dice.share(CaseChoice::Arms);
  double angle = dice.uniform(0.4, 0.85);
  shape.arms_back = dice.uniform(-0.05, 0.15);
  if (arms < 0.2) {
    angle = dice.uniform(0.15, 0.35);
    shape.arms_back = dice.uniform(0.1, 0.35);
  } else if (arms > 0.85) {
    angle = dice.uniform(0.85, 1.05);
  }
  shape.arm_angle = {angle + dice.about(0, 0.02), angle + dice.about(0, 0.02)};
  shape.legs = skirt ? dice.uniform(-0.09, 0.01) : dice.uniform(-0.08, 0.03);
  shape.twist = dice.about(0, 0.03);
  shape.lean = dice.about(0, 0.012);
  shape.stoop = dice.uniform(-0.02, 0.06);
  shape.tilt = dice.about(0, 0.012);
  shape.sway = dice.about(0, 0.007);
}

// Upright, arms sideways and 28 degrees below the horizontal, as the sleeves of a flat T-shirt lie.
BodyShape stretched(BodyShape shape) {
  shape.arm_angle = {1.08, 1.08};
  shape.arms_back = 0.46;
  shape.twist = shape.lean = shape.stoop = shape.tilt = shape.sway = 0;
  return shape;
}

BodyShape between(const BodyShape& from, const BodyShape& to, double share) {
  const auto mix = [&](double a, double b) { return a + share * (b - a); };
  BodyShape out = to;
  for (std::size_t side = 0; side < 2; ++side) {
    out.arm_angle[side] = mix(from.arm_angle[side], to.arm_angle[side]);
  }
  out.arms_back = mix(from.arms_back, to.arms_back);
  out.twist = mix(from.twist, to.twist);
  out.lean = mix(from.lean, to.lean);
  out.stoop = mix(from.stoop, to.stoop);
  out.tilt = mix(from.tilt, to.tilt);
  out.sway = mix(from.sway, to.sway);
  return out;
}

}  // namespace

BodyShape sample_body(Outfit outfit, CaseDice& dice) {
  BodyShape shape;
  const bool female = dice.chance(has_skirt(outfit) ? 0.85 : 0.5);
  shape.blend = sample_blend(female, dice);
  sample_build(dice, shape);
  sample_pose(has_skirt(outfit), dice, shape);
  const bool wide = outfit == Outfit::FlaredSkirt || outfit == Outfit::OversizeTshirt;
  return with_free_arms(shape, has_skirt(outfit) || wide ? 0.08 : 0.025);
}

std::vector<Mesh> dressing_poses(Outfit outfit, const BodyShape& shape) {
  constexpr double kStep = 0.15, kOutOfTheWay = 0.45;
  const double lowest = std::min(shape.arm_angle[0], shape.arm_angle[1]);
  if (!has_tshirt(outfit) && lowest > kOutOfTheWay) return {make_body(shape)};
  const BodyShape first = stretched(shape);
  const double way = std::max(first.arm_angle[0] - lowest, first.arms_back - shape.arms_back);
  const int steps = std::max(1, static_cast<int>(std::ceil(way / kStep)));
  std::vector<Mesh> out;
  out.reserve(static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i < steps; ++i) {
    out.push_back(make_body(between(first, shape, static_cast<double>(i) / steps)));
  }
  out.push_back(make_body(shape));
  return out;
}

}  // namespace regarment
