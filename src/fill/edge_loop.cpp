#include "fill/edge_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "geometry/closed_curve.h"

namespace regarment {

EdgeLoop::EdgeLoop(std::vector<Vec3> points) : points_(std::move(points)) {
  if (points_.empty()) throw InvalidInput("EdgeLoop: a curve needs at least one point");
  double length = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    length += (points_[(i + 1) % points_.size()] - points_[i]).norm();
    ends_.push_back(length);
  }
}

EdgeLoop::Place EdgeLoop::nearest(const Vec3& p) const {
  const CurvePoint found = closest_on_curve(points_, p);
  const double before = found.piece == 0 ? 0.0 : ends_[found.piece - 1];
  const double along = before + found.share * found.along.norm();
  return {(found.point - p).norm(), along < length() ? along : 0.0};
}

Vec3 EdgeLoop::at(double along) const {
  const double s = ahead(0, along);
  const auto piece = std::upper_bound(ends_.begin(), ends_.end(), s);
  if (piece == ends_.end()) return points_.front();
  const auto i = static_cast<std::size_t>(piece - ends_.begin());
  const double begin = i == 0 ? 0.0 : ends_[i - 1];
  return points_[i] +
         (s - begin) / (*piece - begin) * (points_[(i + 1) % points_.size()] - points_[i]);
}

double EdgeLoop::ahead(double from, double to) const {
  if (!(length() > 0)) return 0;
  const double gap = std::fmod(to - from, length());
  return gap < 0 ? gap + length() : gap;
}

double EdgeLoop::step(double from, double to) const {
  const double gap = ahead(from, to);
  return gap > length() / 2 ? gap - length() : gap;
}

}  // namespace regarment
