#pragma once

#include <vector>

#include "garment/panel_outline.h"

namespace regarment {

/// A mark on the outline of a panel that meets its like on another panel when they are sewn, or
/// shows the middle of the panel or the end of a construction line.
struct Notch {
  Vec2 at = Vec2::Zero();      // on the outline, panel coordinates (s, t), m
  Vec2 inward = Vec2::Zero();  // into the panel, unit length
};

/// The notches of a panel whose `outline` is panel_outline's: in the middle of every seam of at
/// least 6 cm one, or two 1 cm apart where both its panels are backs, so that both sides of a seam
/// carry the same; where a panel is cut on the fold, its ends; the ends of construction lines that
/// have a title.
std::vector<Notch> panel_notches(const TemplateData& data, int panel,
                                 const std::vector<OutlineEdge>& outline, const NameScope& scope);

}  // namespace regarment
