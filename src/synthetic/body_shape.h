#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// How a person is built and stands. All zero but the mixture is a body of the library as it is,
/// with the arms at `arm_angle`.
struct BodyShape {
  /// Share of each body of body_library(), in its order; adds up to 1.
  std::array<double, 8> blend = {1, 0, 0, 0, 0, 0, 0, 0};
  double scale = 1.0;  // of all lengths, 0.85 .. 1.15

  // How much the girth grows there, as a share of itself, -0.1 .. 0.2; fades smoothly up and down.
  double belly = 0, chest = 0, hips = 0, thighs = 0;
  double arms = 0;       // girth of the arms, likewise
  double shoulders = 0;  // m, each shoulder further out, -0.02 .. 0.03
  double asymmetry = 0;  // how much more of this the left side has than the right, -0.4 .. 0.4

  // Left, right: angle between arm and the vertical, 0.1 .. 1.1 rad. The arms of the library hang
  // at about 0.7; below 0.35 they come near the hips, see arm_clearance().
  std::array<double, 2> arm_angle = {0.7, 0.7};
  double arms_back = 0;  // rad, the arms, which reach forward by 0.5, further back, -0.1 .. 0.5
  double legs = 0;       // rad, each leg further out, -0.1 .. 0.06; below 0 they come together
  double twist = 0;      // rad, the shoulders to the left against the hips, -0.2 .. 0.2
  double lean = 0;       // rad, of the upper body to the left, -0.08 .. 0.08
  double stoop = 0;      // rad, of the upper body to the front, -0.08 .. 0.12
  double tilt = 0;       // rad, the left shoulder down, -0.06 .. 0.06
  double sway = 0;       // m, the hips to the left of the feet, -0.03 .. 0.03

  /// Throws InvalidInput naming the field and its value.
  void check() const;
};

/// The person, undressed. Body frame: metres, +y up, +z where the hips face, +x to the person's
/// left, lowest point at y = 0; 13,380 vertices, 26,756 outward triangles, closed, no normals.
/// Vertex i is the same place on every body. Throws InvalidInput as check() does.
Mesh make_body(const BodyShape& shape);

/// Smallest distance between forearms or hands and the trunk or legs of a body of make_body, m.
/// An arm that passes through the trunk has nearly none.
double arm_clearance(const Mesh& body);

/// Turns the arms outwards until they keep `clearance` metres from hips and legs, in steps of
/// 0.02 rad. Arms that keep it already stay as they are; none goes beyond 1.1 rad.
BodyShape with_free_arms(BodyShape shape, double clearance);

}  // namespace regarment
