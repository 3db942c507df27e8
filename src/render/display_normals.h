#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// The direction in single precision; zero when there is none.
Eigen::Vector3f unit_or_zero(const Vec3& vector);

/// Sum of the normals of the triangles round each vertex, weighted by area. Not unit length; zero
/// at vertices without triangles. Throws InvalidInput for an index out of range.
std::vector<Vec3> vertex_normals(std::span<const Vec3> positions,
                                 std::span<const Triangle> triangles);

/// The same, summed over all vertices at the very same place: panels sewn together look smooth.
std::vector<Vec3> welded_normals(std::span<const Vec3> positions,
                                 std::span<const Triangle> triangles);

/// Normals of points about `spacing` apart: the direction of least spread among the neighbours
/// within one and a half spacings per axis. Unit length, unoriented; zero where a point stands
/// alone.
std::vector<Eigen::Vector3f> cloud_normals(std::span<const Eigen::Vector3f> points, double spacing);

}  // namespace regarment
