#pragma once

#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// Positions for the particles of `fine` on the cloth of `coarse`: two patterns of one template and
/// the same dimensions, triangulated differently. Each goes to its place in the flat panel's
/// triangle, or, where the coarser panel's curved edge leaves it outside, to the nearest triangle's
/// plane. `x`: one position per coarse particle, m. Returns one per fine particle.
std::vector<Vec3> onto_finer(const Pattern& coarse, const std::vector<Vec3>& x,
                             const Pattern& fine);

}  // namespace regarment
