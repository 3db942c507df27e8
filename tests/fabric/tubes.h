#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "garment/find_template.h"
#include "garment/pattern.h"

namespace regarment::test {

inline Dimensions small_skirt() {
  return {{"length", 0.5}, {"waist", 0.72}, {"hip", 0.96}, {"width", 1.1}};
}

/// A skirt whose every level line lies on a level circle: at panel depth t round it is `girth(t)`
/// long. Exact along the lines, for a panel's line there is straight and its sides meet.
inline std::vector<Vec3> rolled_skirt(const Pattern& pattern, const Dimensions& flat,
                                      const std::function<double(double)>& girth) {
  const auto half_width = [&](double t) {
    const double waist = flat.at("waist"), hip = flat.at("hip"), width = flat.at("width");
    const double below = (t - 0.2) / (flat.at("length") - 0.2);
    return (t < 0.2 ? waist + t / 0.2 * (hip - waist) : hip + below * (width - hip)) / 4;
  };
  std::vector<Vec3> out;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const double s = pattern.flat[v].x(), t = pattern.flat[v].y();
    const bool front = pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[v])];
    const double turn = s / half_width(t) * std::numbers::pi / 2;
    const double radius = girth(t) / (2 * std::numbers::pi);
    const double ahead = radius * std::cos(turn);
    out.emplace_back(radius * std::sin(turn), 1 - t, front ? ahead : -ahead);
  }
  return out;
}

}  // namespace regarment::test
