#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "scan/body_pieces.h"

namespace regarment {

/// The surface of a scan at about a hundredth of its size: one point per cell of a cubic grid, so
/// that a cloud and a mesh, dense parts and thin ones count alike. Only cells of connected pieces
/// that are parts of the body are kept, which drops stray points, islands and posts.
///
/// Depends on where points are, not on their order: cells are laid around the middle of the extent,
/// and a quarter turn of the input turns the sample along.
struct BodySample {
  std::vector<Vec3> points;  // one per kept cell: the mean of what lies in it; unit of the input
  double cell = 0.0;         // edge of a cell
  double longest = 0.0;      // longest side of all that was sampled, but for the farthest few

  /// The body's where `p` lies in a kept cell or in one beside it; else what its own cell's are.
  Belongs at(const Vec3& p) const;

  Vec3 centre;                   // of the grid
  std::array<int, 3> half{};     // cells from the centre to each side of the grid
  std::vector<Belongs> belongs;  // per grid cell
};

/// Samples points, and the triangles between them finely enough that no cell is missed. Where
/// points are sparse the cells grow until most points are connected. `points` must be finite and
/// not empty; fewer than a handful of points, or all at one place, give a sample with few points,
/// never an error.
BodySample sample_body(std::span<const Vec3> points, std::span<const Triangle> triangles);

}  // namespace regarment
