#pragma once

#include "measure/garment_edges.h"

namespace regarment {

/// Says whether an edge is hidden by a garment found before, whose samples `taken` holds on the
/// rows and columns of the edge's own map. An edge beyond which that garment begins is covered and
/// stays where it is: the cloth is cut off there. One that has that garment on its own side is that
/// garment's edge: it is moved to where that one ends, and covered.
void cut_off_where_covered(const LimbView& view, const LimbMap& taken, GarmentEdge& edge);

}  // namespace regarment
