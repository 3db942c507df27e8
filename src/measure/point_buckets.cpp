#include "measure/point_buckets.h"

#include <algorithm>

namespace regarment {

PointBuckets::PointBuckets(const std::vector<Vec2>& points, double size)
    : points_(points), low_(Vec2::Constant(1e9)), size_(size) {
  Vec2 high = -low_;
  for (const Vec2& p : points) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
  nx_ = static_cast<int>((high.x() - low_.x()) / size) + 1;
  ny_ = static_cast<int>((high.y() - low_.y()) / size) + 1;
  first_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) + 1, 0);
  for (const Vec2& p : points) ++first_[cell(p) + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  order_.resize(points.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    order_[next[cell(points[i])]++] = static_cast<int>(i);
}

std::size_t PointBuckets::cell(const Vec2& p) const {
  const int x = std::clamp(static_cast<int>((p.x() - low_.x()) / size_), 0, nx_ - 1);
  const int y = std::clamp(static_cast<int>((p.y() - low_.y()) / size_), 0, ny_ - 1);
  return index(x, y);
}

}  // namespace regarment
