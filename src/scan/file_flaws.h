#pragma once

#include <span>
#include <vector>

#include "scan/finding.h"
#include "scan/scan.h"
#include "scan/weld.h"

namespace regarment {

/// Removes triangles whose three positions an earlier one has, so that each is there once and its
/// edges count as they should. Two faces back to back are a fold, and stay; but where they are many
/// the whole surface was doubled to be seen from both sides, and one of each goes. Returns how many
/// went.
std::size_t drop_repeated(std::vector<Triangle>& triangles, const Welded& welded);

/// The step between neighbouring coordinates that single precision leaves at the point farthest
/// from the origin, in the unit of `vertices`; 0 where a coordinate has more digits than that.
/// Coordinates that are not finite are passed over.
double float_step(std::span<const Vec3> vertices);

/// Says what is wrong with a file's mesh or cloud by itself: points and faces that are there twice
/// (`repeated` faces are gone already), faces without area, edges of three and more faces, and
/// coordinates too far from the origin for their digits. `metres`: of one file unit.
/// `mesh` and `welded` are in the frame of the file.
void note_file_flaws(const Mesh& mesh, const Welded& welded, std::size_t repeated, double metres,
                     std::vector<Finding>& findings);

/// Says when points lie too far apart, or scatter too much, for the edges of cloth.
void note_sampling(const Scan& scan, std::vector<Finding>& findings);

}  // namespace regarment
