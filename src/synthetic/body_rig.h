#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Where a body of body_library() bends and grows, by vertex index, so that it holds for every
/// mixture of these bodies. Made once from the first body.
struct BodyRig {
  /// Left, right: share by which a vertex goes with the arm: 1 from the middle of the upper arm to
  /// the fingers, 0 on the trunk, smooth round the shoulder.
  std::array<std::vector<double>, 2> arm;
  /// Left, right: rings of vertices round the upper arm and round the forearm.
  std::array<std::vector<int>, 2> upper_arm, forearm;
  /// Vertices on the middle line of the front; their heights are the levels of a body.
  int crotch = 0, hip = 0, belly = 0, chest = 0, neck = 0;
};

const BodyRig& body_rig();  // any thread

/// The parts of a body that a pose needs, m.
struct BodyJoints {
  std::array<Vec3, 2> shoulder;   // joints of the arms: left, right
  std::array<Vec3, 2> arm_along;  // unit, from the shoulder towards the hand
  double crotch = 0, hip = 0, belly = 0, chest = 0, neck = 0;  // heights above the floor
};

/// Finds them on a body: one position per vertex of the library.
BodyJoints body_joints(const BodyRig& rig, const std::vector<Vec3>& positions);

/// 0 below `from`, 1 above `to`, with no kink between: 3 u^2 - 2 u^3.
double smooth_step(double from, double to, double value);

}  // namespace regarment
