#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace regarment {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;
using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

/// A triangle mesh, or a point cloud when it has no triangles. Vertices are kept in the order of
/// the file they came from, also those that no triangle uses.
struct Mesh {
  std::vector<Vec3> positions;  // in the frame and unit the owner states
  std::vector<Triangle>
      triangles;              // counter-clockwise seen from outside; every index < positions.size()
  std::vector<Vec3> normals;  // one per vertex, unit length or zero; or empty
  std::vector<Colour> colours;  // one per vertex; or empty

  bool is_cloud() const { return triangles.empty(); }
};

}  // namespace regarment
