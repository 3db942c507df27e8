#include "scan/visible_side.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/parallel.h"

namespace regarment {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kMostPixels = 2000;      // along an edge of a depth picture
constexpr double kHiddenBehind = 1.0;  // pixels a point must lie deeper to be hidden

/// The nearest surface in each pixel, seen from far away along `towards`.
class DepthPicture {
 public:
  DepthPicture(const Vec3& towards, const Vec3& low, const Vec3& high, double pixel)
      : towards_(towards), right_(Vec3::UnitY().cross(towards).stableNormalized()), pixel_(pixel) {
    if (right_.squaredNorm() < 0.5) right_ = Vec3::UnitX();
    upwards_ = towards_.cross(right_);
    const Vec3 middle = (low + high) / 2;
    const double reach = (high - low).norm() / 2;
    side_ = static_cast<int>(2 * reach / pixel) + 5;
    origin_right_ = right_.dot(middle) - pixel * side_ / 2;
    origin_up_ = upwards_.dot(middle) - pixel * side_ / 2;
    depth_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_),
                  -std::numeric_limits<float>::infinity());
  }

  void add(std::span<const Vec3> points) {
    for (const Vec3& p : points) {
      float& depth = depth_[index(p)];
      depth = std::max(depth, static_cast<float>(towards_.dot(p)));
    }
    widen(1);
    widen(static_cast<std::size_t>(side_));
  }

  /// Cosine between the view and the normal where the point is seen, else 0.
  float look(const Vec3& p, const Vec3& normal) const {
    const double in_front = static_cast<double>(depth_[index(p)]) - kHiddenBehind * pixel_;
    return towards_.dot(p) < in_front ? 0.0F : static_cast<float>(towards_.dot(normal));
  }

 private:
  /// Pixel of a point; points outside fall on the rim.
  std::size_t index(const Vec3& p) const {
    const auto pixel_at = [this](double offset) {
      return static_cast<std::size_t>(std::clamp(offset / pixel_, 1.0, side_ - 2.0));
    };
    return pixel_at(upwards_.dot(p) - origin_up_) * static_cast<std::size_t>(side_) +
           pixel_at(right_.dot(p) - origin_right_);
  }

  /// Gives each pixel the nearest depth of itself and its two neighbours at `step`: closes the gaps
  /// between points.
  void widen(std::size_t step) {
    std::vector<float> wide = depth_;
    for (std::size_t i = step; i + step < depth_.size(); ++i) {
      wide[i] = std::max({depth_[i - step], depth_[i], depth_[i + step]});
    }
    depth_ = std::move(wide);
  }

  Vec3 towards_, right_, upwards_;
  double pixel_;
  double origin_right_ = 0, origin_up_ = 0;
  int side_ = 0;
  std::vector<float> depth_;
};

/// Directions towards the viewer: a ring at eye level, two slanted ones, and one from above.
std::vector<Vec3> views() {
  std::vector<Vec3> directions;
  const auto add_ring = [&](int count, double elevation) {
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * kPi * (i + 0.5) / count;
      directions.emplace_back(std::cos(elevation) * std::sin(angle), std::sin(elevation),
                              std::cos(elevation) * std::cos(angle));
    }
  };
  add_ring(12, 0.0);
  add_ring(7, 40 * kPi / 180);
  add_ring(7, -35 * kPi / 180);
  directions.emplace_back(0, 1, 0);
  return directions;
}

}  // namespace

std::vector<float> visible_side(std::span<const Vec3> points, std::span<const Vec3> normals,
                                std::span<const Vec3> occluders, double pixel) {
  std::vector<float> side(points.size(), 0.0F);
  if (occluders.empty()) return side;
  Vec3 low = occluders[0], high = low;
  for (const Vec3& p : occluders) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  pixel = std::max(pixel, (high - low).norm() / kMostPixels);
  if (!(pixel > 0)) return side;
  std::vector<DepthPicture> pictures;
  for (const Vec3& towards : views()) pictures.emplace_back(towards, low, high, pixel);
  parallel_for(pictures.size(), 1,
               [&](std::size_t view, std::size_t) { pictures[view].add(occluders); });
  parallel_for(points.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const DepthPicture& picture : pictures) side[i] += picture.look(points[i], normals[i]);
    }
  });
  return side;
}

}  // namespace regarment
