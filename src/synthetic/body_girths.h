#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// What a tape reads round the trunk of a closed standing mesh (body frame, m, y up) at a height:
/// the perimeter of the convex hull of the slice. The trunk is the outline that encloses the middle
/// of the slice, or below the crotch the two legs nearest to it; arms and hands beside it do not
/// count while they are apart. 0 where the plane cuts nothing.
double tape_girth(const Mesh& body, double height);

/// Heights of a standing person of make_body where garments hold, m above the floor, and what a
/// tape reads there. `hip` is the widest girth between crotch and waist, `waist` the narrowest
/// between hip and chest, `chest` the widest just below the armpits.
struct BodyGirths {
  double crotch = 0;
  double hip_height = 0, waist_height = 0, chest_height = 0;
  double hip = 0, waist = 0, chest = 0;
  double height = 0;  // m, of the person
  double neck_height =
      0;                // m, top of the shoulder 10 cm beside the middle, where it meets the neck
  double shoulder = 0;  // m, half the distance between the joints of the arms
  double arm = 0;       // m, from the shoulder joint to the wrist
  double upper_arm_girth = 0, wrist_girth = 0;
};

/// Measures them.
BodyGirths body_girths(const Mesh& body);

}  // namespace regarment
