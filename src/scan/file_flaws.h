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

/// What is wrong with a file's mesh or cloud by itself.
struct FileFlaws {
  std::size_t not_numbers = 0;  // vertices with a coordinate that is not finite
  std::size_t together = 0;     // points of a cloud exactly where an earlier one lies
  std::size_t repeated = 0;     // faces that were dropped
  std::size_t flat = 0;         // faces without area
  std::size_t crowded = 0;      // edges of three faces and more
  double step = 0.0;            // float_step, unit of the file
};

/// Counts them, in the frame of the file; drops what repeats another face.
FileFlaws find_file_flaws(Mesh& mesh, const Welded& welded);

/// Says them; `metres`: of one file unit.
void note_file_flaws(const FileFlaws& flaws, double metres, std::vector<Finding>& findings);

/// Says when points lie too far apart, or scatter too much, for the edges of cloth.
void note_sampling(const Scan& scan, std::vector<Finding>& findings);

}  // namespace regarment
