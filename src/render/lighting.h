#pragma once

#include <vector>

#include "render/surface.h"

namespace regarment {

/// Studio light on what a camera sees: a warm key light from the upper left, a cool fill from the
/// right, a sky, a soft rim, a little shine, and the shade of hollows (ambient occlusion: a place
/// deeper than its surroundings gets less light). One entry per pixel of the buffers.
std::vector<Light> light_surface(const GeometryBuffers& buffers, double pixels_per_metre);

}  // namespace regarment
