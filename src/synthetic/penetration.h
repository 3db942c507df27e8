#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// How far cloth passes through a closed body, m: the greatest depth of any corner, middle of a
/// side or centroid of its triangles inside; 0 when all are outside. Counted to a depth of 5 cm.
double deepest_inside(const Mesh& body, const std::vector<Triangle>& triangles,
                      const std::vector<Vec3>& positions);

}  // namespace regarment
