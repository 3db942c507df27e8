#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// The distinct positions of a mesh. STL files and meshes split at texture seams hold a position
/// many times; what counts neighbours or borders must see it once.
struct Welded {
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<Vec3> positions;           // each different from all others, finite
  std::vector<std::uint32_t> of_vertex;  // per vertex: index into positions; kNone when not finite
};

/// Joins vertices with exactly equal coordinates (0 equals -0). Positions stand in the order of
/// their first vertex. Vertices with a coordinate that is not finite get kNone.
Welded weld(std::span<const Vec3> vertices);

/// The triangles over welded positions, without those that name a position twice or one that is not
/// finite. `source` (may be null) receives each one's index in `triangles`.
std::vector<Triangle> weld_triangles(std::span<const Triangle> triangles, const Welded& welded,
                                     std::vector<std::uint32_t>* source = nullptr);

}  // namespace regarment
