#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// How the triangles of a welded mesh hang together.
struct MeshEdges {
  /// Two triangles that share an edge no third one has.
  struct Pair {
    std::uint32_t one, other;  // triangles
    bool same_winding;         // seen from one side both turn the same way
  };
  std::vector<Pair> pairs;
  std::vector<std::array<std::uint32_t, 2>> border;  // vertices of edges with one triangle only
  std::size_t crowded = 0;                           // edges with three triangles or more
};

/// `vertices` is the number of vertices the triangles may name.
MeshEdges find_edges(std::span<const Triangle> triangles, std::size_t vertices);

/// Number of holes: connected chains of border edges.
std::size_t count_holes(const MeshEdges& edges, std::size_t vertices);

/// Sheets of surface: triangles connected by pairs. Within a sheet `turn` says which triangles to
/// turn so that all are wound alike (1) or not (0).
struct Sheets {
  std::vector<std::uint32_t> of_triangle;  // sheet number, from 0 in order of first triangle
  std::vector<std::uint8_t> turn;  // per triangle; the greater part of a sheet is left as it is
  std::size_t count = 0;
};

Sheets find_sheets(std::size_t triangles, const MeshEdges& edges);

}  // namespace regarment
