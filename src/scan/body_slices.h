#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// A connected part of a thin slice across the body. Lengths in body heights.
struct SlicePiece {
  static constexpr int kNone = -1;

  std::size_t cells = 0;       // sample points in it: its outline's length, roughly
  Vec2 centre = Vec2::Zero();  // mean of its points
  double width = 0.0;          // extent along its longer principal axis
  double depth = 0.0;          // extent across it
  int below = kNone;           // piece of the next lower slice it overlaps most
  bool tip = true;             // nothing lies over it in the next higher slice
};

/// A body cut into slices of equal height across a direction, each split into connected pieces,
/// largest first; specks are left out. `t` is the height from 0 (robust lowest) to 1 (highest).
struct BodySlices {
  static constexpr int kLevels = 48;

  std::vector<std::vector<SlicePiece>> levels;  // kLevels, lowest first
  std::vector<double> t;                        // per sample point; a few lie outside 0..1
  std::vector<Vec2> across;         // per sample point, from the median, in body heights
  double low = 0.0, height = 0.0;   // along the direction, unit of the points
  double width = 0.0, depth = 0.0;  // of the whole along its horizontal principal axes

  static double middle_of(int level) { return (level + 0.5) / kLevels; }
};

/// Cuts sample points, about `cell` apart, across the unit vector `up`.
BodySlices slice_body(std::span<const Vec3> points, double cell, const Vec3& up);

}  // namespace regarment
