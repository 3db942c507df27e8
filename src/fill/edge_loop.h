#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// A closed curve measured along its length: an open edge of a garment.
class EdgeLoop {
 public:
  /// The closed polyline through `points`, first not repeated, at least one.
  explicit EdgeLoop(std::vector<Vec3> points);

  struct Place {
    double distance = 0;  // of the point asked for, m
    double along = 0;     // 0 <= along < length(), m from the first point
  };
  Place nearest(const Vec3& p) const;  // of several the first

  double length() const { return ends_.back(); }
  Vec3 at(double along) const;  // any number: the curve is closed

  /// How far `to` lies ahead of `from`, 0 <= . < length().
  double ahead(double from, double to) const;
  /// From `from` to `to` the shorter way: positive ahead, negative back.
  double step(double from, double to) const;

 private:
  std::vector<Vec3> points_;
  std::vector<double> ends_;  // per piece: where it ends along the curve, m
};

}  // namespace regarment
