#pragma once

#include <cstdint>
#include <vector>

#include "analysis/hidden_edges.h"
#include "geometry/surface_samples.h"
#include "joint/match_scan.h"
#include "measure/garment_edges.h"

namespace regarment {

/// What the joint fit of a garment looks at: the cloth marked in `cloth` (one per sample), averaged
/// over cells of 8 mm so that noise falls and points are evenly spread (cloth that faces different
/// ways in one cell is kept apart; legs under a hem are left out), and the edges found
/// that nothing covers; those that are hidden lie about where garments of their kind end.
JointTarget joint_target(const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth,
                         const GarmentEdges& edges,
                         const std::map<std::string, HiddenEdge>& hidden = {});

}  // namespace regarment
