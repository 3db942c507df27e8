#pragma once

#include <map>
#include <string>
#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// How long the template's measured lines are on a worn garment: each arrow of the template's
/// drawing is followed over every panel that holds it, also mirrored, and the mean is taken.
/// `positions`: one per pattern vertex, m; the cloth between them is taken to be curved as its
/// normals say, not cut short. Dimension -> length, m; dimensions without an arrow are absent.
std::map<std::string, double> worn_lines(const GarmentTemplate& garment,
                                         const Dimensions& dimensions, const Pattern& pattern,
                                         const std::vector<Vec3>& positions);

/// Length of an arc over its chord, from unit normals at its ends: (phi / 2) / sin(phi / 2) of the
/// angle phi between them in the plane of the chord. 1 where a normal is missing; at most 1.25.
double arc_over_chord(const Vec3& chord, const Vec3& normal_a, const Vec3& normal_b);

}  // namespace regarment
