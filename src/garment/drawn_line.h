#pragma once

#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "garment/pattern.h"

namespace regarment {

/// A straight line across one flat panel, (s, t), m.
struct DrawnLine {
  int panel = 0;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();

  Vec2 along() const { return (to - from).normalized(); }
};

/// Where a dimension is measured on the flat garment: the arrow of the template's drawing on every
/// panel it lies on with nearly all its length, and its mirror image. `pattern` is flat at
/// `dimensions`. Empty for a dimension that is not drawn, or not drawn on cloth.
std::vector<DrawnLine> drawn_lines(const GarmentTemplate& garment, const Dimensions& dimensions,
                                   const Pattern& pattern, const std::string& name);

}  // namespace regarment
