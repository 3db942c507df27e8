#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// One closed outline of a horizontal slice, seen from above: (x, z), m.
struct Loop {
  std::vector<Vec2> points;  // in order round the outline, the first not repeated
  Vec2 low, high;            // its box
  Vec2 centre;               // of its area
  double area = 0;           // m^2, > 0
};

/// Cuts the triangles of a mesh at a height. A vertex on the plane counts as above it, so a closed
/// mesh gives closed outlines. Those that do not close, or enclose nothing, are left out.
std::vector<Loop> slice_loops(const Mesh& mesh, double height);

/// Length of the convex hull of points, m; 0 for none, twice the distance for two.
double hull_perimeter(std::vector<Vec2> points);

}  // namespace regarment
