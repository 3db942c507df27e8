#pragma once

#include <span>

#include "geometry/mesh.h"

namespace regarment {

/// What is cut off a surface. Of the vertices those stay, in their order, that a triangle still
/// uses; normals and colours are not looked at, so trim before there are any.

/// Leaves out separate pieces of fewer than `least` triangles.
void drop_small_pieces(int least, Mesh& mesh);

/// Leaves out triangles with a vertex further than `reach` metres from every point.
void drop_far_triangles(std::span<const Vec3> points, double reach, Mesh& mesh);

}  // namespace regarment
