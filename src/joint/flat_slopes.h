#pragma once

#include <string>
#include <vector>

#include "garment/pattern.h"
#include "garment/springs.h"

namespace regarment {

/// How the flat garment changes with its dimensions.
struct FlatSlopes {
  std::vector<std::string> names;         // dimensions, in the template's order
  std::vector<std::vector<Vec2>> vertex;  // [dimension][pattern vertex]: d flat / d dimension

  std::size_t size() const { return names.size(); }
};

/// Slopes at `dimensions` by central differences of the coarse points, which carry the fine
/// vertices linearly; forward or backward ones where the garment would be impossible on one side.
/// `pattern` belongs to the template. Throws InvalidInput when `dimensions` make no garment.
FlatSlopes flat_slopes(const GarmentTemplate& garment, const Dimensions& dimensions,
                       const Pattern& pattern);

/// d rest length / d dimension for each spring: [spring * slopes.size() + dimension].
std::vector<double> rest_length_slopes(const FlatSlopes& slopes, const Pattern& pattern,
                                       const std::vector<Spring>& springs);

}  // namespace regarment
