#pragma once

#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// Positions of the particles, pattern.particle_count of them, from those of the pattern's vertices
/// (one each, m): vertices that are sewn together lie in one place, the last one counts.
std::vector<Vec3> particle_positions(const Pattern& pattern, const std::vector<Vec3>& vertices);

/// The pattern's triangles over its particles, sewn: only open edges are borders.
std::vector<Triangle> particle_triangles(const Pattern& pattern);

}  // namespace regarment
