#pragma once

#include <array>
#include <string>
#include <vector>

#include "garment/garment_template.h"

namespace regarment {

/// A closed loop of open (unsewn) edge of the sewn garment: waist, hem, neck, a cuff.
struct PatternEdge {
  std::string name;  // "hem", "left_cuff"
  std::string limb;  // limb it goes round: "torso", "left_arm", "right_arm", "neck"
  /// Pattern vertices in order round the loop, one per particle, first not repeated. All loops run
  /// with the garment on their left, seen from outside: seen from above, the hem of a skirt goes
  /// round counter-clockwise and its waist clockwise.
  std::vector<int> vertices;
  /// The pieces of the loop, [i] from vertices[i] on: two vertices of one panel each, so that
  /// |flat[b] - flat[a]| is their length. Where the loop crosses a seam, the second vertex of a
  /// piece and the first of the next are different vertices of one particle.
  std::vector<std::array<int, 2>> segments;
};

/// The flat garment at one set of dimensions, triangulated; and how its triangles are sewn.
///
/// `flat` are panel coordinates (s, t) in metres: s across, to the wearer's left seen from outside
/// the front panel; t down the panel, 0 at the top reference of the template. Panels overlap in
/// this plane (front and back are alike); `panel` tells them apart. Vertices on a seam exist once
/// per panel and share a particle.
struct Pattern {
  std::vector<Vec2> flat;     // n_v x 2, m
  std::vector<int> panel;     // n_v, index into panel_names
  std::vector<int> particle;  // n_v, index of the welded particle, < particle_count
  /// Over vertices, counter-clockwise seen from outside the worn garment: in (s, t), with t
  /// pointing down, front panels have negative area and back panels positive.
  std::vector<Triangle> triangles;
  std::vector<std::string> panel_names;
  std::vector<std::string> panel_limbs;  // "torso", "left_arm", "right_arm": what a panel wraps
  std::vector<bool> panel_is_front;
  std::vector<PatternEdge> edges;
  int particle_count = 0;

  // Each fine vertex inside its panel's coarse triangulation (paper, Fig. 3): three coarse points
  // and weights.
  std::vector<std::array<int, 3>>
      coarse_points;              // n_v x 3, index into the template's coarse points
  std::vector<Vec3> barycentric;  // n_v, sums to 1
};

/// Triangulates the template at its typical dimensions with edges of about `edge_length` metres
/// (0.002 to 0.5), then moves it to `dimensions`. The topology does not depend on `dimensions`: two
/// patterns of one template and edge length differ in `flat` alone. Front and back, left and right
/// are triangulated alike. Throws InvalidInput when `dimensions` make no garment (bounds are not
/// looked at; GarmentTemplate::nearest_possible helps), when `edge_length` is out of range or would
/// make more than a million particles.
Pattern make_pattern(const GarmentTemplate& garment, const Dimensions& dimensions,
                     double edge_length);

/// Moves an existing pattern of this template to other dimensions: coarse points move, fine
/// vertices follow by their barycentric coordinates. Exact, no triangulation. Throws InvalidInput
/// as make_pattern does; the pattern is then unchanged.
void move_pattern(const GarmentTemplate& garment, const Dimensions& dimensions, Pattern& pattern);

/// The template's coarse points at these dimensions, panel coordinates in metres; what
/// Pattern::coarse_points counts. Panels cut on the fold have two sets, left half then right half.
std::vector<Vec2> coarse_points(const GarmentTemplate& garment, const Dimensions& dimensions);

/// The edge of this name. Throws InvalidInput when there is none.
const PatternEdge& edge_named(const Pattern& pattern, const std::string& name);

/// Closed length of an edge of the flat pattern, m.
double loop_length(const Pattern& pattern, const PatternEdge& edge);

}  // namespace regarment
