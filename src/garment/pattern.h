#pragma once

#include <string>
#include <vector>

#include "garment/garment_template.h"

namespace regarment {

/// A closed loop of open (unsewn) edge of the sewn garment: waist, hem, neck, a cuff.
struct PatternEdge {
  std::string name;   // "hem", "left_cuff"
  std::string limb;   // limb it goes round: "torso", "left_arm", "right_arm", "neck"
  std::vector<int> vertices;  // pattern vertices in order round the loop, every panel vertex once per
                              // particle, first not repeated
};

/// The flat garment at one set of dimensions, triangulated; and how its triangles are sewn.
///
/// `flat` are panel coordinates (s, t) in metres: s across, to the wearer's left seen from outside
/// the front panel; t down the panel, 0 at the top reference of the template. Panels overlap in
/// this plane (front and back are alike); `panel` tells them apart. Vertices on a seam exist once per
/// panel and share a particle.
struct Pattern {
  std::vector<Vec2> flat;           // n_v x 2, m
  std::vector<int> panel;           // n_v, index into panel_names
  std::vector<int> particle;        // n_v, index of the welded particle, < particle_count
  std::vector<Triangle> triangles;  // over vertices, counter-clockwise seen from outside the worn garment
  std::vector<std::string> panel_names;
  std::vector<std::string> panel_limbs;  // "torso", "left_arm", "right_arm": what a panel wraps
  std::vector<bool> panel_is_front;
  std::vector<PatternEdge> edges;
  int particle_count = 0;

  // Each fine vertex inside its panel's coarse triangulation (paper, Fig. 3): three coarse points and weights.
  std::vector<std::array<int, 3>> coarse_points;  // n_v x 3, index into the template's coarse points
  std::vector<Vec3> barycentric;                  // n_v, sums to 1
};

/// Triangulates the template at its reference (typical) dimensions with edges of about
/// `edge_length` metres, then moves it to `dimensions`. The topology does not depend on
/// `dimensions`: two patterns of one template and edge length differ in `flat` alone.
Pattern make_pattern(const GarmentTemplate& garment, const Dimensions& dimensions, double edge_length);

/// Moves an existing pattern to other dimensions: coarse points move, fine vertices follow by their
/// barycentric coordinates. Exact, no triangulation.
void move_pattern(const GarmentTemplate& garment, const Dimensions& dimensions, Pattern& pattern);

}  // namespace regarment
