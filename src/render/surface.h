#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "render/display_mesh.h"
#include "render/geometry_pass.h"

namespace regarment {

/// How a pixel is lit: colour = albedo * (r, g, b) + shine, in linear light.
struct Light {
  float r = 0, g = 0, b = 0, shine = 0;
};

/// A mesh as one camera sees it, ready to be coloured in any look.
struct Surface {
  const DisplayMesh* mesh = nullptr;
  GeometryBuffers seen;
  std::vector<Light> light;                // per pixel of `seen`, meaningful where id is not 0
  std::vector<Eigen::Vector2f> projected;  // per vertex, in pixels of `seen`; empty for a cloud

  /// Shares of the triangle's corners in the colour at the pixel's centre; sum 1. Slightly outside
  /// 0..1 at borders.
  std::array<float, 3> barycentric(const Triangle& triangle, int x, int y) const;
};

/// Draws and lights the mesh, which is uploaded already. `camera` is the supersampled one.
Surface see_surface(GeometryPass& pass, const UploadedMesh& uploaded, const DisplayMesh& mesh,
                    const Vec3& origin, const Camera& camera);

}  // namespace regarment
