#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// A mesh or cloud as pictures show it: fewer vertices, each remembering the vertex of the original
/// whose attributes (label, colour, value) it shows.
struct DisplayMesh {
  std::vector<Eigen::Vector3f> positions;  // m, relative to the `origin` it was made with
  std::vector<Eigen::Vector3f> normals;  // one per vertex, unit or zero; a cloud's may point inward
  std::vector<Triangle> triangles;       // empty for a cloud
  std::vector<std::uint32_t> source_vertex;    // per vertex: index in the original
  std::vector<std::uint32_t> source_triangle;  // per triangle: index in the original
  double spacing = 0.0;  // m, of a cloud: discs of this radius meet, all but a few

  bool is_cloud() const { return triangles.empty(); }
};

/// Makes the display mesh of a scan. A mesh of more than `max_elements` triangles, and every cloud,
/// is thinned by clustering its vertices on a uniform grid (the sides of a thin sheet stay apart by
/// the direction of their normals, the sides of a border by their labels); a cluster stands at the
/// mean of its vertices and shows the attributes of the vertex nearest to it. A cloud has at most
/// `max_elements` points.
///
/// Vertices with `outlier` 1 and the triangles that use them are left out; `labels` and
/// `outlier` may be empty.
/// Normals are the mesh's own where it has them, else those of its triangles; a cloud without
/// normals gets them from the neighbouring clusters, unoriented. Deterministic.
/// The result is empty when nothing is left. Throws InvalidInput for a vertex that is not finite.
DisplayMesh make_display_mesh(const Mesh& mesh, std::span<const std::uint8_t> labels,
                              std::span<const std::uint8_t> outlier, const Vec3& origin,
                              std::size_t max_elements);

/// The display mesh of a garment, in full. Vertices at the same place (seams) share a normal.
DisplayMesh make_display_mesh(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                              const Vec3& origin);

}  // namespace regarment
