#pragma once

#include <span>

#include "scan/person_likeness.h"

namespace regarment {

/// Where a person faces.
struct Front {
  Vec3 direction = Vec3::UnitZ();  // unit, horizontal, in the frame of the points
  double confidence = 0.5;         // 0.5 (could be either way round) .. 1
  double mismatch = 0.0;           // of the left-right mirror plane, see MirrorPlane
};

/// Finds the line from the left-right mirror plane and the way round from toes before ankles, face
/// before the neck, hands before the shoulders, seat behind the waist and calves behind the thighs.
/// `upright` are points in body heights, +y up, floor at 0; `likeness` says where the neck is.
Front find_front(std::span<const Vec3> upright, const PersonLikeness& likeness);

}  // namespace regarment
