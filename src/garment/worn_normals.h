#pragma once

#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// Outward unit normals of a worn garment's particles, each triangle weighed by its area; zero
/// where the cloth around a particle has none. `particles`: pattern.particle_count positions, m.
std::vector<Vec3> worn_normals(const Pattern& pattern, const std::vector<Vec3>& particles);

}  // namespace regarment
