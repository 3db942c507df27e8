#include "synthetic/depth_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kNearest = 0.2;  // m
constexpr double kMostPixels = 1 << 24;

// A vertex in the picture. 1 / depth is linear across a triangle's picture.
struct Corner {
  double x = 0, y = 0, inverse = 0;
};

// Twice the area of a, b, (x, y); linear in x and y.
double side_of(const Corner& a, const Corner& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

int first_middle(double low) { return static_cast<int>(std::ceil(low - 0.5)); }
int last_middle(double high) { return static_cast<int>(std::floor(high - 0.5)); }

struct Buffers {
  DepthPicture& picture;
  std::vector<double> inverse;  // 1 / depth, 0: nothing

  void draw(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id) {
    const double area = side_of(a, b, c.x, c.y);
    if (area == 0) return;
    const DepthCamera& camera = picture.camera;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const int x0 = std::max(0, first_middle(left));
    const int x1 = std::min(camera.width - 1, last_middle(right));
    const int y0 = std::max(0, first_middle(top));
    const int y1 = std::min(camera.height - 1, last_middle(bottom));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double u = side_of(b, c, x + 0.5, y + 0.5) / area;
        const double v = side_of(c, a, x + 0.5, y + 0.5) / area;
        const double w = 1 - u - v;
        // Rounding must not leave a gap between neighbours; an overlap does no harm.
        if (std::min({u, v, w}) < -1e-9) continue;
        const double near = u * a.inverse + v * b.inverse + w * c.inverse;
        const std::size_t i = picture.index(x, y);
        if (near <= inverse[i]) continue;
        inverse[i] = near;
        picture.triangle[i] = id;
      }
  }
};

}  // namespace

Vec3 DepthCamera::pixel_from_body(const Vec3& point) const {
  const Vec3 view = view_from_body * (point - eye);
  const double scale = focal / -view.z();
  return {axis_x + scale * view.x(), axis_y - scale * view.y(), -view.z()};
}

Vec3 DepthCamera::body_from_pixel(const Vec3& pixel) const {
  const Vec3 view((pixel.x() - axis_x) / focal, (axis_y - pixel.y()) / focal, -1);
  return eye + pixel.z() * (view_from_body.transpose() * view);
}

DepthCamera aim_camera(const Vec3& eye, const Vec3& target, double half_height, double pixel,
                       std::span<const Vec3> points) {
  const Vec3 back = (eye - target).normalized();
  const Vec3 right = Vec3::UnitY().cross(back);
  if (!(right.norm() > 1e-6))
    throw InvalidInput("a depth camera stands above what it looks at: move it to the side");
  DepthCamera camera;
  camera.eye = eye;
  camera.view_from_body << right.normalized().transpose(),
      back.cross(right).normalized().transpose(), back.transpose();
  camera.focal = (eye - target).norm() / pixel;
  double low = 0, high = 0;
  for (const Vec3& point : points) {
    const Vec3 p = camera.pixel_from_body(point);
    if (!(p.z() >= kNearest))
      throw InvalidInput("a depth camera has something nearer than 0.2 m before it, or behind it");
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  const double rows = 2 * std::ceil(half_height / pixel), columns = std::ceil(high - low) + 2;
  if (!(rows * columns <= kMostPixels))
    throw InvalidInput("a depth picture has more than 2^24 pixels: make them larger");
  camera.width = static_cast<int>(columns);
  camera.height = static_cast<int>(rows);
  camera.axis_x = std::ceil(-low) + 1;
  camera.axis_y = rows / 2;
  return camera;
}

DepthPicture draw_depth(const DepthCamera& camera, std::span<const Vec3> positions,
                        std::span<const Triangle> triangles) {
  DepthPicture picture;
  picture.camera = camera;
  const std::size_t pixels = std::size_t(camera.width) * std::size_t(camera.height);
  picture.triangle.assign(pixels, DepthPicture::kNone);
  std::vector<Corner> corners;
  corners.reserve(positions.size());
  for (const Vec3& position : positions) {
    const Vec3 p = camera.pixel_from_body(position);
    corners.push_back({p.x(), p.y(), 1 / p.z()});
  }
  Buffers buffers{picture, std::vector<double>(pixels, 0.0)};
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    buffers.draw(corners[triangles[t][0]], corners[triangles[t][1]], corners[triangles[t][2]], t);
  picture.depth = std::move(buffers.inverse);
  for (double& depth : picture.depth) depth = 1 / depth;
  return picture;
}

}  // namespace regarment
