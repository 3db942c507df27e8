#pragma once

#include <cstdint>
#include <vector>

#include "measure/garment_edges.h"
#include "scan/scan.h"

namespace regarment {

/// Marks the triangles that a surface reconstruction invented to close a garment at its hem or
/// cuffs (paper, sec. 3.4 and Fig. 5): beside the edge, inside its loop and facing along the limb.
/// Returns one entry per triangle, 1 = cap; empty for a cloud.
std::vector<std::uint8_t> find_caps(const Scan& scan, const GarmentEdges& edges);

/// Number of connected caps of at least `least_area` m^2.
int count_caps(const Scan& scan, const std::vector<std::uint8_t>& cap, double least_area = 5e-4);

}  // namespace regarment
