#pragma once

#include "measure/garment_edges.h"

namespace regarment {

/// Does a cuff close in the armpit? Beside a lowered arm the lower part of a wide, short sleeve's
/// edge lies between arm and trunk, where no camera looks: what shows of it is only a part. Such a
/// cuff ends within 9 cm of the armpit, and the lowest place seen of its edge is not below the
/// armpit. Cuffs on raised arms hang free, covered ones say nothing: false.
bool is_tucked(const GarmentEdge& cuff, const GarmentEdges& edges, const Body& body);

/// Share of a garment's cuffs that are tucked, 0..1; 0 without cuffs.
double tucked_share(const GarmentEdges& edges, const Body& body);

}  // namespace regarment
