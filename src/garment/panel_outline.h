#pragma once

#include <string>
#include <vector>

#include "garment/template_data.h"

namespace regarment {

/// One edge of a whole panel as it is cut, in panel coordinates (s, t), m.
struct OutlineEdge {
  EdgeRef ref;
  std::string name;          // sides swapped for mirrored parts
  bool is_free = false;      // not sewn
  std::vector<Vec2> points;  // the straight pieces, both ends included
  std::vector<Vec2>
      controls;  // Bezier: none straight, 1 quadratic, 2 cubic (an ellipse's: within 0.03 %)
};

/// The edges of a panel in order round it; a panel cut on the fold is unfolded. Each edge starts
/// where the one before ends.
std::vector<OutlineEdge> panel_outline(const TemplateData& data, int panel, const NameScope& scope);

}  // namespace regarment
