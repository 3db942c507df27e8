#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// What a part of a scan belongs to.
enum class Belongs : std::uint8_t {
  Body,
  Sheet,   // a floor or a wall
  Post,    // a column beside the person
  Island,  // any other piece apart from the person
  Stray,   // single points, or a few
  Nowhere  // a vertex whose coordinates are no numbers
};

/// A connected piece of a sampled scan.
struct SamplePiece {
  std::vector<Vec3> points;  // one per cell of the sampling grid
  std::size_t samples = 0;   // vertices, and samples of triangles, in these cells
};

/// Tells the pieces that are parts of the body from those that are not. The largest is the body;
/// others are too when they are large and near it (legs under an open hem, a head over hair that
/// was not seen), unless they are straight columns that no line along themselves joins to the body,
/// as it joins an arm. `cell` is the distance of the points in a piece, `longest` the longest side
/// of all. One entry per piece.
std::vector<Belongs> judge_pieces(std::span<const SamplePiece> pieces, double cell, double longest);

}  // namespace regarment
