#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scan/mesh_edges.h"

namespace regarment {

/// Which triangles to turn so that a mesh is seen from outside counter-clockwise.
struct Winding {
  std::vector<std::uint8_t> turn;  // per triangle
};

/// Makes each sheet wound alike, then turns sheets that are seen from their inside. Sheets hardly
/// seen from outside (a body under clothes) go with the mesh as a whole, in which triangles at
/// `stray` positions (one entry per position) have no vote. Body frame, +y up; `occluders` are a
/// sample of the surface at most about `pixel` apart.
Winding outward_winding(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                        const MeshEdges& edges, std::span<const std::uint8_t> stray,
                        std::span<const Vec3> occluders, double pixel);

/// Area-weighted normals, one per position, unit. Positions without a triangle, or whose triangles
/// cancel out, take that of the nearest position that has one; +y where there is none at all.
std::vector<Vec3> mesh_normals(std::span<const Vec3> positions,
                               std::span<const Triangle> triangles);

}  // namespace regarment
