#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Points of a plane by square cells, for questions about what lies near. Borrows the points, which
/// must outlive it and be at least one.
class PointBuckets {
 public:
  /// `size`: m, edge of a cell, and the largest distance that can be asked for.
  PointBuckets(const std::vector<Vec2>& points, double size);

  /// Calls `visit(point)` for every point that may lie within `size` of `p`, and some others, in an
  /// order that depends on the points' order alone.
  template <typename Visit>
  void near(const Vec2& p, Visit visit) const {
    const int cx = static_cast<int>(std::floor((p.x() - low_.x()) / size_));
    const int cy = static_cast<int>(std::floor((p.y() - low_.y()) / size_));
    for (int y = std::max(0, cy - 1); y <= std::min(ny_ - 1, cy + 1); ++y)
      for (int x = std::max(0, cx - 1); x <= std::min(nx_ - 1, cx + 1); ++x) {
        const std::size_t c = index(x, y);
        for (int k = first_[c]; k < first_[c + 1]; ++k) visit(points_[order_[k]]);
      }
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
           static_cast<std::size_t>(x);
  }
  std::size_t cell(const Vec2& p) const;

  const std::vector<Vec2>& points_;
  Vec2 low_;
  double size_;
  int nx_ = 0, ny_ = 0;
  std::vector<int> first_, order_;  // first_: of each cell into order_
};

}  // namespace regarment
