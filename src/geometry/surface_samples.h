#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Points spread evenly over a surface, so that meshes with large triangles and point clouds can be
/// measured alike. All vectors have one entry per sample.
struct SurfaceSamples {
  std::vector<Vec3> positions;        // frame and unit of the mesh
  std::vector<Vec3> normals;          // unit or zero
  std::vector<Vec3> colours;          // red, green, blue in 0..1; empty when the mesh has none
  std::vector<double> areas;          // m^2 of surface a sample stands for
  double spacing = 0;                 // m, typical distance between neighbouring samples
  std::vector<std::uint32_t> vertex;  // a vertex of the mesh it came from (nearest corner)

  std::size_t size() const { return positions.size(); }
};

/// Samples the triangles of a mesh at most `spacing` apart, or takes the points of a cloud as they
/// are (each standing for spacing^2, `spacing` then being what the cloud has). Vertices marked in
/// `skip` (one per vertex, may be empty) and triangles touching them are left out. Needs vertex
/// normals. Order follows the triangles'.
SurfaceSamples sample_surface(const Mesh& mesh, double spacing,
                              const std::vector<std::uint8_t>& skip = {});

}  // namespace regarment
