#pragma once

#include <array>
#include <vector>

#include "garment/template_data.h"

namespace regarment {

/// How the coarse points of a shape hang together; does not depend on the dimensions. Coarse points
/// are the shape's vertices, then its points, then the samples of its curved edges in edge order.
struct ShapeOutline {
  int points = 0;
  std::vector<std::vector<int>> edges;  // coarse points along each edge, both ends included
  std::vector<int> fold;                // along the fold from the last edge's end to the first
                                        // edge's start; empty without a fold
  std::vector<std::array<int, 2>> lines;
};

/// Coarse points of a shape, m.
std::vector<Vec2> shape_points(const ShapeData& shape, const NameScope& scope);

/// `points`: the shape's coarse points at typical dimensions; they order the points on the fold.
ShapeOutline shape_outline(const ShapeData& shape, const std::vector<Vec2>& points);

/// The outline as one closed polygon of coarse points in the file's order, fold included.
std::vector<int> closed_outline(const ShapeOutline& outline);

/// Outline, fold and lines as segments between coarse points.
std::vector<std::array<int, 2>> all_segments(const ShapeOutline& outline);

}  // namespace regarment
