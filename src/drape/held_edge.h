#pragma once

#include <vector>

#include "drape/attraction.h"

namespace regarment {

/// An open edge of the cloth whose place on the scan is known, such as a hem or a waist: it is
/// drawn to a curve instead of to the nearest surface.
struct HeldEdge {
  std::vector<int> particles;  // of the cloth, on the edge
  std::vector<Vec3> curve;     // closed, first not repeated, at least 3 points, body frame, m
};

/// Draws the particles of the edges to their curves: replaces their entries of `attraction`. A
/// departure from the paper, whose authors placed a garment by hand and found its upper edge
/// "almost impossible" to tell from the scan (sec. 4). Throws InvalidInput when an edge names a
/// particle there is not, or has no curve.
void hold(const std::vector<HeldEdge>& edges, const Cloth& cloth,
          std::vector<Attraction>& attraction);

}  // namespace regarment
