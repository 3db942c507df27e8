#pragma once

#include <vector>

#include "fill/edge_loop.h"
#include "geometry/mesh.h"

namespace regarment {

/// Points of a garment's cloth where a cloud shows none: spread over the cloth at the cloud's
/// `spacing` (m, mean distance between its points, > 0), each farther from every point of the cloud
/// than the gaps a scanner leaves between points. Groups of them that are small or that only run
/// along an open edge of the garment (`edges`) are left out: there the cloth is too long, not the
/// cloud too short. `cloth` in the frame of `cloud`, with `normals`.
std::vector<Vec3> fill_cloud(const std::vector<Vec3>& cloud, const Mesh& cloth,
                             const std::vector<EdgeLoop>& edges, double spacing);

}  // namespace regarment
