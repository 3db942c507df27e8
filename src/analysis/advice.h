#pragma once

#include <vector>

#include "placement/body.h"
#include "scan/finding.h"

namespace regarment {

/// What a person could do better when the scan is made again, from the body taken apart: an arm
/// that touches the torso or is not seen apart from it, legs that touch far below the crotch.
std::vector<Finding> advise(const Body& body);

}  // namespace regarment
