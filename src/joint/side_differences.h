#pragma once

#include <string>
#include <vector>

#include "joint/joint_fit.h"
#include "joint/sides.h"

namespace regarment {

/// A dimension that may differ between two sides.
struct SidedDimension {
  std::string name;
  Sides sides = Sides::LeftRight;
};

/// How the flat garment changes when a dimension grows by half a metre per metre on one side (left,
/// front) and shrinks as much on the other. On the trunk this passes evenly from side to side: from
/// one side seam to the other, or from the middle of the front to that of the back; a sleeve is one
/// side as a whole.
std::vector<Vec2> sided_slope(const FlatSlopes& slopes, const Pattern& pattern,
                              const SidedDimension& sided);

/// How much longer each dimension is on its left (front) side than on the other, m: the fit goes on
/// from where it ended, with the differences as dimensions of their own, one triangulation coarser.
/// `target` and `lengths` as for joint_fit. Throws InvalidInput for an unknown dimension.
std::vector<double> side_differences(const GarmentTemplate& garment, const JointFit& fit,
                                     const JointTarget& target,
                                     const std::vector<MeasuredLength>& lengths,
                                     const std::vector<SidedDimension>& sided,
                                     const JointOptions& options);

}  // namespace regarment
