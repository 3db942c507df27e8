#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Distances to the points of a slice on a grid of 2 mm, and what of the plane can be reached from
/// outside without coming within `reach` of a point.
class OutlineField {
 public:
  /// `points`: at least one, m. `reach`: m.
  OutlineField(const std::vector<Vec2>& points, double reach);

  /// Whether the outside has come in through a gap: it holds most of the surroundings of `centre`.
  bool leaks(const Vec2& centre) const;

  /// The closed curve at distance `reach` round the points that enclose `centre`, where it borders
  /// on the outside; vertices in order, at most 3 mm apart, first not repeated. Empty when nothing
  /// encloses the centre.
  std::vector<Vec2> contour(const Vec2& centre);

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
           static_cast<std::size_t>(x);
  }
  void measure(const std::vector<Vec2>& points);
  void flood();
  std::vector<std::pair<int, int>> heart(const Vec2& centre) const;
  void mark_own(const Vec2& centre);

  double reach_;
  Vec2 low_ = Vec2::Zero();  // of the grid
  int nx_ = 0, ny_ = 0;
  std::vector<float> distance_;        // at grid points, capped at 2 reach
  std::vector<std::uint8_t> outside_;  // 1: reached from the border at distance > reach
  std::vector<std::uint8_t> own_;  // 1: not outside, and joined to the surroundings of the centre
};

}  // namespace regarment
