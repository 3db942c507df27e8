#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Constrained Delaunay triangulation of the region enclosed by `segments` (pairs of indices into
/// `points`; they may also run inside). Segments meet in shared points only. Every point lies in
/// the region or on its border. Triangles have negative area in (s, t): counter-clockwise as seen
/// when t points down. Same input, same output. A point that CGAL finds twice throws InvalidInput.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec2>& points,
                                            const std::vector<std::array<int, 2>>& segments);

/// Points that Delaunay refinement puts inside the same region so that no triangle edge is much
/// longer than `edge_length` and no angle is small. Points on the segments are left out: how the
/// segments are divided is the caller's choice. Sorted.
std::vector<Vec2> refinement_points(const std::vector<Vec2>& points,
                                    const std::vector<std::array<int, 2>>& segments,
                                    double edge_length);

}  // namespace regarment
