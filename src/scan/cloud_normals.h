#pragma once

#include <span>
#include <vector>

#include "scan/local_surface.h"

namespace regarment {

/// Turns the normals of a cloud to the outside: by the side a point is seen from, and where it is
/// not seen or hardly, by agreement with its neighbours. Frame: +y up. `spacing` is the
/// cloud's; points near in the list should be near in space.
void orient_outward(std::span<const Vec3> points, double spacing, LocalSurface& surface);

/// What became of the normals a file brought along.
enum class GivenNormals { Absent, Kept, Flipped, Replaced };

/// Puts the file's own normals (one per point, or empty) in place of estimated ones where that is
/// plausible: most lie along the estimated ones; then they are kept if they point outward, flipped
/// if inward, and taken with the estimated side if mixed. Implausible ones are replaced.
GivenNormals prefer_given(std::span<const Vec3> given, std::vector<Vec3>& estimated);

}  // namespace regarment
