#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Where a welded mesh ends: closed loops of vertices along edges that only one triangle has, the
/// first vertex not repeated, the mesh on the right seen from outside, so that a hole lies on the
/// left. A loop that comes through a vertex twice is taken apart there: no loop names a vertex
/// twice. Loops that meet an edge with three triangles, or two that turn differently, are left
/// out. In order of their first edges. Every index must be < `vertices`, no triangle may name a
/// vertex twice.
std::vector<std::vector<std::uint32_t>> border_loops(std::span<const Triangle> triangles,
                                                     std::size_t vertices);

}  // namespace regarment
