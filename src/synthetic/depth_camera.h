#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Perspective camera that looks along its own -z: x to the right and y up in the view, pixel
/// (i, j) counted from the upper left corner, its middle at i + 0.5, j + 0.5. Depth is measured
/// along the viewing axis, m, > 0 before the camera.
struct DepthCamera {
  Vec3 eye = Vec3::Zero();                                       // body frame, m
  Eigen::Matrix3d view_from_body = Eigen::Matrix3d::Identity();  // rows: right, up, backwards
  double focal = 1.0;                                            // pixels
  // Where the viewing axis goes through the picture, pixels from its upper left corner.
  double axis_x = 0.0, axis_y = 0.0;
  int width = 0, height = 0;  // pixels

  /// (x pixels, y pixels, depth m).
  Vec3 pixel_from_body(const Vec3& point) const;
  /// Inverse of `pixel_from_body`.
  Vec3 body_from_pixel(const Vec3& pixel) const;
};

/// A camera at `eye` that looks at `target`, the picture's upright as near to +y as can be. The
/// picture reaches `half_height` metres up and down at the target, and to the sides just as far as
/// `points` do; `pixel` is the side of a pixel at the target, m. Throws InvalidInput when eye and
/// target lie above each other, when the picture would have more than 2^24 pixels, or when a point
/// lies less than 0.2 m before the eye or behind it.
DepthCamera aim_camera(const Vec3& eye, const Vec3& target, double half_height, double pixel,
                       std::span<const Vec3> points);

/// What a camera sees: per pixel, row by row, the nearest triangle at the pixel's middle.
struct DepthPicture {
  static constexpr std::uint32_t kNone = 0xffffffff;

  DepthCamera camera;
  std::vector<std::uint32_t> triangle;  // kNone: nothing
  std::vector<double> depth;            // m, exact at the middle; infinite where there is nothing

  std::size_t index(int x, int y) const { return std::size_t(y) * camera.width + x; }
};

/// Draws the triangles, front and back sides alike. Exact at the middle of each pixel; of equally
/// near triangles the first counts. Every position must lie before the camera, as `aim_camera`
/// makes sure. Depends on the input alone.
DepthPicture draw_depth(const DepthCamera& camera, std::span<const Vec3> positions,
                        std::span<const Triangle> triangles);

}  // namespace regarment
