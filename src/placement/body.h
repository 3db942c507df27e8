#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "placement/slices.h"

namespace regarment {

/// Where a sample belongs on the body.
enum class BodyPart : std::uint8_t { Trunk, LeftArm, RightArm, Loose };

/// Horizontal extent of the trunk (torso, skirt or both legs, neck, head) at one level.
struct TrunkLevel {
  double y = 0;  // m, middle of the slice
  double x_min = 0, x_max = 0, z_min = 0, z_max = 0;
  bool present = false;
  bool left_arm_joined = false, right_arm_joined = false;  // cut off at the armpit's width
  int pieces = 0;  // clusters the trunk consists of (2 for separate legs)

  Vec2 centre() const { return {(x_min + x_max) / 2, (z_min + z_max) / 2}; }  // x, z
};

/// The middle line of an arm.
struct ArmAxis {
  std::vector<Vec3> points;  // from the armpit outwards to the fingertips, at least 2 when present
  bool present() const { return points.size() >= 2; }
};

/// A scanned body taken apart. Body frame, metres. Levels are heights above the floor.
struct Body {
  double height = 0;
  std::vector<TrunkLevel> trunk;  // one per slice level, from the floor up
  double slice_height = 0.01;
  double fork = 0;  // where the legs or the hem of a skirt join, going up
  bool fork_is_garment =
      false;  // true: the join is sudden and convex, as a hem is; false: a crotch
  std::array<double, 2>
      armpit{};  // left, right: where arm (or sleeve) and trunk part; 0 when absent
  std::array<double, 2> armpit_x{};  // x of the trunk's side there
  double neck = 0;                   // narrowest level below the head
  double shoulder = 0;               // level where neck and trunk meet
  std::array<ArmAxis, 2> arms;       // left (x > 0), right
  double arm_axis_lead =
      0.15;  // m of each arm axis that lie within the trunk, before the armpit's plane
  std::vector<BodyPart> part;  // one per sample

  const TrunkLevel& level(double y) const;
  std::map<std::string, double> landmarks() const;  // name -> height above the floor, m
};

/// Takes a standing person apart by horizontal slices. Throws NoPersonError when there is no trunk
/// with something like legs below and a head above.
Body find_body(const SurfaceSamples& samples, double height);

}  // namespace regarment
