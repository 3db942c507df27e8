#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// A garment as it lies on a scan.
struct FillCloth {
  std::vector<Vec3> positions;           // m, in the frame of the scan
  std::vector<Triangle> triangles;       // counter-clockwise seen from outside
  std::vector<std::vector<Vec3>> edges;  // its open edges as closed curves, the first point not
                                         // repeated, the garment on their left seen from outside
};

/// A scan whose holes under garments are closed.
struct FilledScan {
  Mesh mesh;                         // the scan's vertices and triangles first, then what was added
  std::vector<std::uint8_t> filled;  // per vertex: 1 = added
  std::size_t holes = 0;             // closed; of a cloud: 0
  double area = 0;                   // m^2, of the triangles added; of a cloud: 0
};

/// Closes the holes of a scan that lie under garments with the cloth fitted there [Hasler et al.
/// 2007, sec. 4 and Fig. 6].
///
/// A mesh gets triangles that share the vertices of the hole's border, so that every edge of the
/// former hole has two triangles; a hole that runs out under an open edge of the garment is closed
/// up to that edge. What a closed mesh has in its holes already stays, and so does every hole of
/// the person. A cloud gets points at its own spacing.
///
/// `labels`: one per vertex, 0 person, i = `cloths[i - 1]`. `outlier`: empty or one per vertex, 1 =
/// a point of a cloud that shows no surface. `spacing`: m, mean distance between
/// neighbouring points of a cloud; not used for a mesh. The mesh comes back without normals and
/// colours. Throws InvalidInput for sizes that do not match.
FilledScan fill_scan(const Mesh& scan, std::span<const std::uint8_t> labels,
                     std::span<const std::uint8_t> outlier, const std::vector<FillCloth>& cloths,
                     double spacing);

}  // namespace regarment
