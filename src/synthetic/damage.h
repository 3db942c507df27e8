#pragma once

#include "base/random.h"
#include "synthetic/scanner.h"

namespace regarment {

/// What happens to a cloud besides the faults of its sensors.
struct DamageOptions {
  int holes = 0;              // 0 .. 50 places where nothing was measured
  double hole_radius = 0.03;  // m, 0.005 .. 0.2: a hole is three balls, the largest of this radius
  double stray = 0.0;         // 0 .. 0.1: stray points, as a share of the others
  double stray_reach = 0.15;  // m, 0 .. 1: they lie anywhere in the box of the others, so enlarged

  void check() const;  // throws InvalidInput naming the field and its value
};

/// Takes points away and adds stray ones at the end, of label 255. The middle of a hole is a point
/// of the person or a garment. A scan without points stays so.
void apply_damage(const DamageOptions& options, Random& random, ScannedPerson& scan);

}  // namespace regarment
