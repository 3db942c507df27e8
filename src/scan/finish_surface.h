#pragma once

#include <span>

#include "scan/scan.h"
#include "scan/weld.h"

namespace regarment {

/// A scan in the body frame whose surface is still to be looked at.
struct RawSurface {
  const Welded& welded;             // vertices to positions; these in the body frame, m
  std::vector<std::uint8_t> stray;  // per welded position: 1 = away from the body
  std::vector<Vec3> sample;         // of the body, body frame, m
  double sample_spacing = 0.0;      // m
};

/// Fills in what a surface shows by itself: outward normals, outliers, spacing, noise, holes, and
/// the warnings about them; turns triangles to face outward. `scan.mesh` holds the file's vertices,
/// triangles and (turned along) normals.
void finish_surface(const RawSurface& raw, Scan& scan);

/// Measures spacing and noise of all positions that are not `stray`, m.
void measure_sampling(std::span<const Vec3> positions, std::span<const std::uint8_t> stray,
                      ScanFacts& facts);

}  // namespace regarment
