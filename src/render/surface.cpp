#include "render/surface.h"

#include <array>
#include <cmath>

#include "render/lighting.h"
#include "render/smooth_normals.h"

namespace regarment {

std::array<float, 3> Surface::barycentric(const Triangle& triangle, int x, int y) const {
  const Eigen::Vector2f p(float(x) + 0.5F, float(y) + 0.5F);
  const Eigen::Vector2f a = projected[triangle[0]] - p, b = projected[triangle[1]] - p,
                        c = projected[triangle[2]] - p;
  const float wa = b.x() * c.y() - b.y() * c.x();
  const float wb = c.x() * a.y() - c.y() * a.x();
  const float wc = a.x() * b.y() - a.y() * b.x();
  const float sum = wa + wb + wc;
  if (std::abs(sum) < 1e-12F) return {1.0F, 0.0F, 0.0F};
  return {wa / sum, wb / sum, wc / sum};
}

Surface see_surface(GeometryPass& pass, const UploadedMesh& uploaded, const DisplayMesh& mesh,
                    const Vec3& origin, const Camera& camera) {
  Surface surface;
  surface.mesh = &mesh;
  surface.seen = pass.draw(uploaded, camera);
  if (mesh.is_cloud()) {
    smooth_normals(surface.seen, mesh.spacing * camera.pixels_per_metre, 3.0 * mesh.spacing);
  } else {
    const Eigen::Vector2f shift =
        (camera.pixel_from_body(origin).head<2>() - Vec2(surface.seen.left, surface.seen.top))
            .cast<float>();
    Eigen::Matrix<float, 2, 3> pixel_from_point;
    pixel_from_point.row(0) =
        (camera.pixels_per_metre * camera.view_from_body.row(0)).cast<float>();
    pixel_from_point.row(1) =
        (-camera.pixels_per_metre * camera.view_from_body.row(1)).cast<float>();
    surface.projected.reserve(mesh.positions.size());
    for (const Eigen::Vector3f& p : mesh.positions) {
      surface.projected.emplace_back(pixel_from_point * p + shift);
    }
  }
  surface.light = light_surface(surface.seen, camera.pixels_per_metre);
  return surface;
}

}  // namespace regarment
