#include "render/clip_matrix.h"

namespace regarment {

Eigen::Matrix4f clip_from_body(const Camera& camera, const Vec3& origin) {
  Eigen::Matrix4d clip_from_view = Eigen::Matrix4d::Identity();
  clip_from_view(0, 0) = 2.0 * camera.pixels_per_metre / camera.width;
  clip_from_view(1, 1) = -2.0 * camera.pixels_per_metre / camera.height;
  clip_from_view(2, 2) = -1.0 / camera.depth_range;
  Eigen::Matrix4d view_from_point = Eigen::Matrix4d::Identity();
  view_from_point.topLeftCorner<3, 3>() = camera.view_from_body;
  view_from_point.topRightCorner<3, 1>() = camera.view_from_body * (origin - camera.centre);
  return (clip_from_view * view_from_point).cast<float>();
}

}  // namespace regarment
