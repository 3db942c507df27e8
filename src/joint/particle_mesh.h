#pragma once

#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// The pattern's triangles over its particles, sewn: only open edges are borders.
std::vector<Triangle> particle_triangles(const Pattern& pattern);

}  // namespace regarment
