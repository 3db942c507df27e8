#pragma once

#include "garment/garment_template.h"

namespace regarment {

/// Dimensions of a garment that can be made, near `wanted`, with those in `held` (m, by name)
/// exactly as given; as GarmentTemplate::nearest_possible for the others. Nothing held is that
/// function. Always the same for the same arguments.
/// Throws UsageError when a held name is unknown, its value is out of bounds, or no garment was
/// found that has the held dimensions together.
Dimensions nearest_holding(const GarmentTemplate& garment, const Dimensions& wanted,
                           const Dimensions& held);

}  // namespace regarment
