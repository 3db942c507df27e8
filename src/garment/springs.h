#pragma once

#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// A side of a triangle as a spring between two particles. The two vertices lie on one panel; on a
/// seam, whose sides have equal flat length, on either of its two.
struct Spring {
  int particle_a = 0, particle_b = 0;  // a < b
  int vertex_a = 0, vertex_b = 0;      // for the rest length, also after move_pattern
  double rest_length = 0.0;            // m, > 0
};

/// Every pair of particles joined by a triangle's side, once, sorted by (a, b).
std::vector<Spring> springs(const Pattern& pattern);

/// Takes the rest lengths from the pattern again, after move_pattern. Same pattern topology.
void update_rest_lengths(const Pattern& pattern, std::vector<Spring>& springs);

/// Flat area of each triangle, m^2, > 0 for a valid pattern.
std::vector<double> triangle_areas(const Pattern& pattern);

/// Mass of each particle, kg: a third of each triangle at it. `area_density`: kg/m^2, > 0.
std::vector<double> particle_masses(const Pattern& pattern, double area_density);

}  // namespace regarment
