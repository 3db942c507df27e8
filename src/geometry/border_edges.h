#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Where the triangles `kept` of a mesh end. One entry per kept triangle: bit k says that its
/// corner k ends an edge that only one of them has, bit 3 + k that its edge facing corner k is
/// such an edge. A triangle that names a vertex twice has no edges. Every index must be in range.
std::vector<std::uint8_t> border_flags(std::span<const Triangle> triangles,
                                       std::span<const std::uint32_t> kept, std::size_t vertices);

}  // namespace regarment
