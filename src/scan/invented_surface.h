#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Marks the surface that a reconstruction invented where there was no data: a mesher of even
/// density gets few, large triangles there. Per position 1 where edges are far longer than usual,
/// grown over the neighbourhood in which they are longer on average. A mesh that is uneven all over
/// (modelled, or simplified by shape) says nothing of its data, and no position is marked.
/// `triangles` are over welded positions. Any frame and unit.
std::vector<std::uint8_t> find_invented(std::span<const Vec3> positions,
                                        std::span<const Triangle> triangles);

}  // namespace regarment
