#pragma once

#include <string>

#include "exports/garment_glb.h"

namespace regarment {

/// The garment as a Wavefront OBJ file, sewn: one `v` per particle (metres, y up), one `vt` per
/// pattern vertex (s and -t, its flat coordinates in metres, so that a drawing stands upright), one
/// group per panel. A cloth simulator that takes rest lengths from UV finds them true. Throws
/// InvalidInput when the sizes differ.
std::string garment_obj(const DressedGarment& garment);

}  // namespace regarment
