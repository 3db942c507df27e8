#include "render/strokes.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr float kStray = 0.015F;  // m: a smooth line cuts through the folds of its surface

/// Nearest place to (x, y) on the segment from a to b in the picture, 0..1 along it.
double nearest_along(const Vec3& a, const Vec3& b, double x, double y) {
  const double u = b.x() - a.x(), v = b.y() - a.y(), square = u * u + v * v;
  if (square < 1e-12) return 0;
  return std::clamp(((x - a.x()) * u + (y - a.y()) * v) / square, 0.0, 1.0);
}

}  // namespace

Strokes::Strokes(const std::vector<std::span<const Vec3>>& curves, const Camera& camera,
                 double half_width) {
  std::vector<std::vector<Vec3>> seen;
  double low = 1e300, high = -1e300;
  for (const std::span<const Vec3> curve : curves) {
    if (curve.size() < 2) continue;
    seen.emplace_back();
    for (std::size_t i = 0; i < curve.size(); ++i) {
      check_drawable(curve[i], i);
      seen.back().push_back(camera.pixel_from_body(curve[i]));
      low = std::min(low, seen.back().back().y()), high = std::max(high, seen.back().back().y());
    }
  }
  if (seen.empty()) return;
  const double tallest = camera.height - 1;
  top_ = static_cast<int>(std::clamp(std::floor(low - half_width), 0.0, tallest));
  const int last = static_cast<int>(std::clamp(std::ceil(high + half_width), 0.0, tallest));
  rows_.resize(static_cast<std::size_t>(last - top_) + 1);
  left_ = camera.width;
  for (const std::vector<Vec3>& curve : seen)
    for (std::size_t i = 0; i < curve.size(); ++i)
      add_segment(curve[i], curve[(i + 1) % curve.size()], half_width, camera);
  left_ = std::min(left_, right_);
}

void Strokes::add_segment(const Vec3& a, const Vec3& b, double half_width, const Camera& camera) {
  const auto from = [&](double low) { return std::max(0.0, std::floor(low - half_width)); };
  const auto to = [&](double high, int size) { return std::min(size - 1.0, high + half_width); };
  const double right = to(std::max(a.x(), b.x()), camera.width);
  const double bottom = to(std::max(a.y(), b.y()), camera.height);
  for (double y = from(std::min(a.y(), b.y())); y <= bottom; ++y)
    for (double x = from(std::min(a.x(), b.x())); x <= right; ++x) {
      const double along = nearest_along(a, b, x + 0.5, y + 0.5);
      const Vec3 on = a + along * (b - a);
      if (std::hypot(on.x() - x - 0.5, on.y() - y - 0.5) > half_width) continue;
      const int column = static_cast<int>(x);
      rows_[static_cast<std::size_t>(static_cast<int>(y) - top_)].push_back(
          {column, static_cast<float>(on.z())});
      left_ = std::min(left_, column), right_ = std::max(right_, column + 1);
    }
}

void Strokes::paint(PaintRow& row) const {
  if (row.y < top() || row.y >= bottom()) return;
  for (const Dot& dot : rows_[static_cast<std::size_t>(row.y - top_)]) {
    const auto column = static_cast<std::size_t>(dot.x);
    if (dot.depth <= row.depth[column] + kStray) row.colour[column] = linear(border_colour());
  }
}

}  // namespace regarment
