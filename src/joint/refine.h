#pragma once

#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// Positions of the particles of `fine`, from those of another triangulation of the same garment at
/// the same dimensions: each fine vertex lies where its flat point lies on the coarse cloth.
std::vector<Vec3> refine(const Pattern& coarse, const std::vector<Vec3>& x, const Pattern& fine);

}  // namespace regarment
