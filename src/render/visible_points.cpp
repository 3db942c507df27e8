#include "render/visible_points.h"

#include <algorithm>
#include <limits>

namespace regarment {
namespace {

struct Raster {
  int width, height;
  std::vector<float> depth;

  Raster(int w, int h)
      : width(w), height(h), depth(std::size_t(w) * h, std::numeric_limits<float>::infinity()) {}
  float& at(int x, int y) { return depth[std::size_t(y) * width + x]; }
};

// Per square the deepest of the nine nearest depths: everything behind it is covered all round.
Raster deepest_around(Raster& nearest) {
  Raster deepest(nearest.width, nearest.height);
  for (int y = 1; y + 1 < nearest.height; ++y) {
    for (int x = 1; x + 1 < nearest.width; ++x) {
      float worst = nearest.at(x, y);
      for (int n = 0; n < 9; ++n) worst = std::max(worst, nearest.at(x + n % 3 - 1, y + n / 3 - 1));
      deepest.at(x, y) = worst;
    }
  }
  return deepest;
}

}  // namespace

std::vector<std::uint32_t> visible_points(std::span<const Eigen::Vector3f> points,
                                          const Vec3& origin, const Camera& camera, double reach,
                                          double depth_margin) {
  const Vec3 shift = camera.pixel_from_body(origin);
  const double scale = camera.pixels_per_metre / reach;
  Raster nearest(int(camera.width / reach) + 1, int(camera.height / reach) + 1);
  const Eigen::Vector3f right = (scale * camera.view_from_body.row(0)).cast<float>();
  const Eigen::Vector3f down = (-scale * camera.view_from_body.row(1)).cast<float>();
  const Eigen::Vector3f away = -camera.view_from_body.row(2).cast<float>();
  const auto shift_x = static_cast<float>(shift.x() / reach);
  const auto shift_y = static_cast<float>(shift.y() / reach);
  std::vector<std::uint32_t> squares;
  squares.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    const float x = std::clamp(right.dot(point) + shift_x, 0.0F, float(nearest.width - 1));
    const float y = std::clamp(down.dot(point) + shift_y, 0.0F, float(nearest.height - 1));
    squares.push_back(std::uint32_t(int(y) * nearest.width + int(x)));
    float& depth = nearest.depth[squares.back()];
    depth = std::min(depth, away.dot(point));
  }
  const Raster deepest = deepest_around(nearest);
  const auto margin = static_cast<float>(depth_margin);
  std::vector<std::uint32_t> visible;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (away.dot(points[i]) <= deepest.depth[squares[i]] + margin) visible.push_back(i);
  }
  return visible;
}

}  // namespace regarment
