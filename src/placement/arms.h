#pragma once

#include "placement/body.h"

namespace regarment {

/// Finds the arms among the samples beside the trunk: the largest connected piece on each side,
/// followed from the trunk outwards. Fills arms and part of `body`; an arm that is not there stays
/// empty.
void find_arms(const SurfaceSamples& samples, const std::vector<bool>& in_trunk, Body& body);

}  // namespace regarment
