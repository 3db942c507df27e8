#pragma once

#include <functional>
#include <numeric>

#include "placement/limb_map.h"
#include "support/dice.h"

namespace regarment::test {

/// How points lie on a made limb about the upright line over the origin.
struct LimbPlan {
  std::function<double(double s, double phi)> radius;  // m, at height s
  std::function<Vec3(double s, double phi)> colour;    // 0..1; empty = no colours
  std::function<bool(double s, double phi)> missing;   // true: the scan has a hole here
  double low = 0.4, high = 1.0;                        // m
  double spacing = 0.003;                              // m between points
  double noise = 0;                                    // m, standard deviation along the ray
};

/// Points on the limb at random places near to a regular grid; normals point away from the axis.
inline SurfaceSamples limb_samples(const LimbPlan& plan, std::uint64_t seed) {
  Dice dice(seed);
  SurfaceSamples samples;
  const int rows = static_cast<int>((plan.high - plan.low) / plan.spacing);
  for (int i = 0; i < rows; ++i) {
    const double around = 2 * std::numbers::pi * plan.radius(plan.low + i * plan.spacing, 0);
    const int columns = static_cast<int>(around / plan.spacing);
    for (int j = 0; j < columns; ++j) {
      const double s = plan.low + (i + dice.uniform(0, 1)) * plan.spacing;
      const double phi =
          (j + dice.uniform(0, 1)) / columns * 2 * std::numbers::pi - std::numbers::pi;
      const double offset = plan.noise > 0 ? dice.normal(plan.noise) : 0.0;
      if (plan.missing && plan.missing(s, phi)) continue;
      const Vec3 out(std::sin(phi), 0, std::cos(phi));
      samples.positions.push_back((plan.radius(s, phi) + offset) * out + Vec3(0, s, 0));
      samples.normals.push_back(out);
      samples.areas.push_back(plan.spacing * plan.spacing);
      samples.vertex.push_back(static_cast<std::uint32_t>(samples.vertex.size()));
      if (plan.colour) samples.colours.push_back(plan.colour(s, phi));
    }
  }
  return samples;
}

/// The upright axis over the origin; s is the height.
inline LimbAxis upright_axis(double low, double high) {
  return LimbAxis({Vec3(0, low, 0), Vec3(0, high, 0)}, {low, high}, Vec3::UnitZ());
}

inline std::vector<int> all_of(const SurfaceSamples& samples) {
  std::vector<int> members(samples.size());
  std::iota(members.begin(), members.end(), 0);
  return members;
}

inline LimbMap limb_map(const LimbPlan& plan, std::uint64_t seed, int columns = 144,
                        double step = 0.004) {
  const SurfaceSamples samples = limb_samples(plan, seed);
  return make_limb_map(samples, all_of(samples), upright_axis(plan.low, plan.high), plan.low,
                       plan.high, step, columns);
}

}  // namespace regarment::test
