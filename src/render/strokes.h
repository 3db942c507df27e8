#pragma once

#include <span>
#include <vector>

#include "render/camera.h"
#include "render/paint.h"

namespace regarment {

/// Lines on a surface as one camera sees them, row by row of the supersampled picture.
class Strokes {
 public:
  /// `curves`: closed, body frame, m; those of fewer than two points are left out. `camera` is the
  /// supersampled one, `half_width` in its pixels.
  Strokes(const std::vector<std::span<const Vec3>>& curves, const Camera& camera,
          double half_width);

  /// First row with a line, one beyond the last, and the same of columns; all 0 without lines.
  int top() const { return top_; }
  int bottom() const { return top_ + static_cast<int>(rows_.size()); }
  int left() const { return left_; }
  int right() const { return right_; }

  /// Paints the lines over the row where they lie in front of what is there, or behind it by less
  /// than a drawn line strays from its surface.
  void paint(PaintRow& row) const;

 private:
  struct Dot {
    int x = 0;
    float depth = 0;  // m
  };
  void add_segment(const Vec3& a, const Vec3& b, double half_width, const Camera& camera);

  int top_ = 0, left_ = 0, right_ = 0;
  std::vector<std::vector<Dot>> rows_;
};

}  // namespace regarment
