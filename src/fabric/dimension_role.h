#pragma once

#include <string>

#include "garment/garment_template.h"
#include "garment/pattern.h"

namespace regarment {

/// What holds a dimension's line on the worn garment.
enum class DimensionRole {
  BearingEdge,  // a top edge that carries the garment: a waist
  TorsoEdge,    // another edge round the trunk: a hem
  LimbEdge,     // an edge round an arm: a cuff
  Hoop,         // round the trunk, away from an edge: a hip, a chest
  Seam,         // round the seam between a limb and the trunk: an armhole
  Length,       // along cloth of the trunk that hangs from the shoulders
  WaistLength,  // along cloth of the trunk that hangs from a bearing edge
  LimbLength,   // along a limb: a sleeve
};

/// The role of a dimension by the template's observations, the highest of those that tell of it:
/// a hoop away from an edge before the edge. An edge bears when it is the upper end of a garment
/// that no neck or shoulder holds. A dimension that nothing observes is a Length, or a Hoop when it
/// is a circumference. Throws InvalidInput for an unknown dimension.
DimensionRole dimension_role(const GarmentTemplate& garment, const Dimensions& dimensions,
                             const Pattern& pattern, const std::string& name);

}  // namespace regarment
