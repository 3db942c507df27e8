#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Vertices gathered by the cells of a uniform grid and the main direction of their normals, so
/// that the two sides of a thin sheet stay apart.
struct VertexClusters {
  static constexpr std::uint32_t kLeftOut = 0xffffffff;
  std::vector<std::uint32_t> of_vertex;  // per vertex: its cluster, or kLeftOut
  std::size_t count = 0;                 // clusters, numbered by their first vertex
};

/// `normals` and `labels` may be empty. Vertices with `outlier` 1 are left out; `outlier` may be
/// empty. `cell` > 0, m, and at least a 2^-18th of the box. Time in proportion to the vertices.
VertexClusters cluster_vertices(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                std::span<const std::uint8_t> labels,
                                std::span<const std::uint8_t> outlier, const Vec3& low,
                                double cell);

}  // namespace regarment
