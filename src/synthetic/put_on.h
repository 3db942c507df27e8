#pragma once

#include <vector>

#include "garment/pattern.h"
#include "geometry/mesh.h"

namespace regarment {

/// Holds the front panels of a garment in front of a standing body and the back panels behind it,
/// sewn together beside it and wide enough that nothing passes through: where a garment starts
/// before it falls into place. `clothed` are the body and what it wears already, body frame. A
/// garment without sleeves has its top edge at `top_height` m; one with sleeves is lowered until
/// its shoulders and sleeves nearly lie on those of the body, whose arms should be held as the
/// sleeves are cut. Returns one position per particle, m, `clearance` m away from the body.
std::vector<Vec3> put_on(const Pattern& pattern, const std::vector<const Mesh*>& clothed,
                         double top_height, double clearance);

}  // namespace regarment
