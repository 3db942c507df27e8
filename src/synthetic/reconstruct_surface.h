#pragma once

#include "geometry/mesh.h"
#include "synthetic/reconstruct_field.h"

namespace regarment {

/// The surface where a field is zero, by surface nets [Gibson 1998]: one vertex in each cell that
/// it passes, in the middle of where it crosses the cell's edges; one pair of triangles around each
/// crossed edge, counter-clockwise seen from where the field is positive. Closed unless the field
/// changes its sign on the border of the grid. Frame and unit of the field.
Mesh zero_surface(const DistanceField& field);

}  // namespace regarment
