#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "garment/find_template.h"
#include "garment/pattern.h"

namespace regarment::test {

inline bool is_possible(const GarmentTemplate& garment, const Dimensions& dimensions) {
  try {
    garment.check(dimensions);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

/// Random dimensions within the bounds that make a garment; every second one at bounds only.
inline std::vector<Dimensions> possible_dimensions(const GarmentTemplate& garment, int count) {
  std::mt19937 random(7);
  std::vector<Dimensions> samples;
  for (int draw = 0; static_cast<int>(samples.size()) < count && draw < 100 * count; ++draw) {
    Dimensions dimensions;
    for (const Dimension& d : garment.dimensions()) {
      double share = static_cast<double>(random()) / 4294967296.0;
      if (draw % 2 == 1) share = share < 0.5 ? 0.0 : 1.0;
      dimensions[d.name] = d.lower + share * (d.upper - d.lower);
    }
    if (is_possible(garment, dimensions)) samples.push_back(dimensions);
  }
  return samples;
}

/// Key points of the T-shirt's left half as scans/README.md of the test scans defines them, in
/// metres, worked out here once more, by trigonometry instead of by the template's formulas.
struct ShirtPoints {
  Vec2 neck, shoulder, end, cuff, underarm;
  Vec2 sleeve_underarm;    // of the sleeve's own panel
  bool is_turned = false;  // the sleeve would end inside the body, so its panel is turned
  explicit ShirtPoints(const Dimensions& d) {
    const double radians = std::acos(-1.0) / 180.0;
    const double half = d.at("width") / 4.0;
    const double s = std::min(0.86 * half, 0.235);
    neck = Vec2(0.09, 0.0);
    shoulder = Vec2(s, (s - 0.09) * std::sin(20 * radians) / std::cos(20 * radians));
    const Vec2 along(std::cos(28 * radians), std::sin(28 * radians));
    end = shoulder + d.at("sleeve_length") * along;
    cuff = end + d.at("sleeve_opening") / 2.0 * Vec2(-along.y(), along.x());
    const double angle = std::acos((half - s) / (d.at("sleeve_seam") / 2.0));
    underarm = shoulder + d.at("sleeve_seam") / 2.0 * Vec2(std::cos(angle), std::sin(angle));
    // The underarm point of the sleeve must lie 1 cm before the line of the opening.
    const double farthest = d.at("sleeve_length") - 0.01;
    is_turned = (underarm - shoulder).dot(along) > farthest;
    sleeve_underarm = underarm;
    if (is_turned) {
      const double turned = 28 * radians + std::acos(farthest / (d.at("sleeve_seam") / 2.0));
      sleeve_underarm =
          shoulder + d.at("sleeve_seam") / 2.0 * Vec2(std::cos(turned), std::sin(turned));
    }
  }
};

}  // namespace regarment::test
