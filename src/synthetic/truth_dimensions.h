#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "synthetic/dressed_person.h"

namespace regarment {

/// The garment's dimensions as they lie on the body, m: the line each is measured along on the flat
/// garment, followed over the worn cloth; the mean of left and right, front and back.
Dimensions worn_dimensions(const GarmentTemplate& garment, const WornGarment& worn);

/// Dimensions a scan cannot tell, in the template's order: no observation of the template that
/// gives the dimension has at least half of each of its edges (or of its line, away from an edge)
/// within a triangle's reach of a particle that was seen. `seen`: one entry per particle, 0 or 1.
/// Throws InvalidInput when there are not as many.
std::vector<std::string> hidden_dimensions(const GarmentTemplate& garment, const WornGarment& worn,
                                           std::span<const std::uint8_t> seen);

}  // namespace regarment
