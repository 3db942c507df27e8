#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// A mesh or cloud with fewer vertices, and which of them stands for each vertex of the original.
struct ThinMesh {
  static constexpr std::uint32_t kNone = 0xffffffff;

  Mesh mesh;
  std::vector<std::uint32_t> of_vertex;  // per original vertex; kNone for one that is not finite
};

/// Joins the vertices of a cubic grid's cell that face the same way into their mean, the cells so
/// large that about `vertices` remain (within a quarter, where that can be met). The two sides of
/// thin cloth stay apart. Normals and colours are means too. Vertices stand in the order of their
/// cells, so it does not depend on the order of the original's, but for the last bits of the means.
ThinMesh thin_mesh(const Mesh& mesh, std::size_t vertices);

}  // namespace regarment
