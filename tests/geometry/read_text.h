#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/mesh_io.h"
#include "support/texts.h"

namespace regarment::test {

/// Parses a file held in a string.
inline Mesh read_text(const std::string& file, MeshFormat format,
                      const MeshReadLimits& limits = {}) {
  return parse_mesh(std::as_bytes(std::span(file)), format, "test file", limits);
}

/// What the reader complains, or nothing when it does not.
inline std::string complaint(const std::string& file, MeshFormat format,
                             const MeshReadLimits& limits = {}) {
  return refusal_of<ReadError>([&] { read_text(file, format, limits); });
}

using Corners = std::vector<Triangle>;

/// The promises of `Mesh` and of the readers.
inline void expect_valid(const Mesh& mesh) {
  ASSERT_FALSE(mesh.positions.empty());
  for (const Vec3& p : mesh.positions) ASSERT_TRUE(p.allFinite());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) ASSERT_LT(corner, mesh.positions.size());
  }
  ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
  ASSERT_TRUE(mesh.colours.empty() || mesh.colours.size() == mesh.positions.size());
  for (const Vec3& n : mesh.normals) {
    const double length = n.norm();
    ASSERT_TRUE(length == 0.0 || std::abs(length - 1.0) < 1e-12) << length;
  }
}

}  // namespace regarment::test
