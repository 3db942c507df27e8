#pragma once

#include <map>
#include <string>
#include <vector>

#include "garment/pattern.h"
#include "placement/limb_map.h"

namespace regarment {

/// What a garment is wrapped round: the limbs, and how high on them its open edges sit.
struct PlacementTarget {
  const std::map<std::string, LimbView>* limbs =
      nullptr;  // "torso", "left_arm", "right_arm", "neck"
  std::map<std::string, std::vector<double>>
      edge_s;  // edge name -> s per column of its limb's map, m
};

struct PlacementOptions {
  // Distance between the wrapped garment and the body, m. Larger clears folds, and lies further
  // off.
  double clearance = 0.02;

  void check() const;  // throws InvalidInput
};

/// Where a garment starts: wrapped round the body outside of it, panels of the torso by the angle
/// round the trunk's axis, sleeves along the arms and round their axes. Returns one position per
/// pattern vertex, body frame, m; vertices of one particle share a position.
/// Throws InvalidInput when the torso is missing among the limbs.
std::vector<Vec3> place_garment(const Pattern& pattern, const PlacementTarget& target,
                                const PlacementOptions& options = {});

}  // namespace regarment
