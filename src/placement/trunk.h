#pragma once

#include "placement/body.h"

namespace regarment {

/// Follows the trunk through the slices, from the narrowest level of the middle up and down, and
/// cuts off what joins it from the side (arms, hands). Fills trunk, armpit and armpit_x of `body`
/// and, for each sample, whether it belongs to the trunk. Throws NoPersonError without a trunk.
std::vector<bool> follow_trunk(const Slices& slices, const SurfaceSamples& samples, Body& body);

}  // namespace regarment
