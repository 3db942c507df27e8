#pragma once

#include <span>

#include "geometry/mesh.h"

namespace regarment {

/// A cut as people make it at neck or wrists. What lies beyond the plane and hangs together with
/// the cut is taken away, however far it goes.
struct FlatCut {
  Vec3 point = Vec3::Zero();    // on the plane, m
  Vec3 normal = Vec3::UnitY();  // unit, towards what is taken away
  double radius = 0.15;         // m: only where the plane meets the surface so near to `point`
};

/// What is cut off a surface. Of the vertices those stay, in their order, that a triangle still
/// uses; normals and colours are not looked at, so trim before there are any.

/// Leaves out separate pieces of fewer than `least` triangles.
void drop_small_pieces(int least, Mesh& mesh);

/// Takes a part away. Triangles that the plane crosses are cut, so that the border lies in it.
void cut_flat(const FlatCut& cut, Mesh& mesh);

/// Leaves out triangles with a vertex further than `reach` metres from every point.
void drop_far_triangles(std::span<const Vec3> points, double reach, Mesh& mesh);

}  // namespace regarment
