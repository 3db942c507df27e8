#pragma once

#include "geometry/surface_samples.h"
#include "measure/edge_finder.h"

namespace regarment {

/// A surface made from points goes on a little beyond cloth that ends in the air, and bends round
/// there. Moves the columns of an edge that show a drop back to where their surface begins to bend,
/// by at most a centimetre. `garment_above` as in EdgeSearch. Clouds have no rim and stay as they
/// are.
void trim_rim(const SurfaceSamples& samples, const LimbView& view, bool garment_above,
              FoundEdge& edge);

}  // namespace regarment
