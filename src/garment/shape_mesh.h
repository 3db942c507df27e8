#pragma once

#include <array>
#include <vector>

#include "garment/shape.h"

namespace regarment {

/// A triangulated shape. Its vertices are given by weights on coarse points, so it holds at any
/// dimensions.
struct ShapeMesh {
  std::vector<std::array<int, 3>> coarse;     // per vertex: three coarse points of the shape
  std::vector<Vec3> weights;                  // per vertex: sums to 1
  std::vector<std::array<int, 3>> triangles;  // negative area in (s, t)
  std::vector<std::vector<int>> edges;  // vertices along each edge of the shape, ends included
  std::vector<bool> on_fold;            // per vertex
};

/// Number of equal parts of every straight piece of every edge of a shape: [edge][piece].
using Divisions = std::vector<std::vector<int>>;

/// What stays the same for all meshes of one shape.
struct ShapeFrame {
  ShapeOutline outline;
  std::vector<Vec2> points;                   // coarse points at typical dimensions, m
  std::vector<std::array<int, 3>> triangles;  // coarse triangulation
};

/// How often each piece of each edge is divided to have edges of about `edge_length`, m. An edge is
/// divided at least once, for two panels sewn together at both its ends must not share it whole.
Divisions divisions_for(const ShapeFrame& frame, double edge_length);

/// Edges divided as asked, fold and lines by their length, the inside by Delaunay refinement.
/// No side of a triangle runs through the inside from outline to outline: after sewing, such a side
/// of the front panel and its twin of the back panel could join the same two particles.
ShapeMesh fine_mesh(const ShapeFrame& frame, const Divisions& divisions, double edge_length);

}  // namespace regarment
