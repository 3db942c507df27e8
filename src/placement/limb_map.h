#pragma once

#include <functional>
#include <vector>

#include "geometry/surface_samples.h"
#include "placement/body.h"

namespace regarment {

/// Where a point lies on a limb: along its axis, around it and away from it.
struct LimbPoint {
  double s = 0;    // m along the axis
  double phi = 0;  // radians in (-pi, pi], 0 at the limb's reference direction
  double r = 0;    // m from the axis
};

/// The axis of a limb as a polyline with a reference direction for phi = 0.
/// Trunk: s is the height above the floor, phi = 0 in front and pi/2 at the person's left.
/// Arm: s runs from the plane of the armpit outwards, phi = 0 on the upper side, pi/2 in front for
/// the left arm and behind for the right one.
/// Neck: rays from a point inside the upper torso; s is the angle from straight up times 0.15 m,
/// r the distance from that point, phi as for the trunk.
class LimbAxis {
 public:
  /// `points` at parameters `s` (ascending, m); `reference` is made perpendicular at each point.
  LimbAxis(std::vector<Vec3> points, std::vector<double> s, const Vec3& reference);

  /// Rays from `centre`, as described for the neck.
  static LimbAxis polar(const Vec3& centre);

  LimbPoint locate(const Vec3& p) const;
  Vec3 point(const LimbPoint& p) const;
  /// Unit vector from the axis outwards at (s, phi).
  Vec3 radial(double s, double phi) const;
  Vec3 tangent(double s) const;
  double s_min() const { return s_.front(); }
  double s_max() const { return s_.back(); }

 private:
  std::size_t segment(double s) const;

  LimbAxis() = default;

  bool vertical_ = false;  // every point straight over the parameter y: located by height alone
  bool polar_ = false;     // rays from points_[0]
  std::vector<Vec3> points_;
  std::vector<double> s_;
  std::vector<Vec3> tangent_, zero_, quarter_;  // frame at each point
  friend LimbAxis trunk_axis(const Body& body);
};

LimbAxis trunk_axis(const Body& body);
LimbAxis arm_axis(const Body& body, int side);
LimbAxis neck_axis(const Body& body);

/// The outer surface of a limb as a height field r(s, phi) on a regular grid.
/// Row i is at s_low + (i + 0.5) * step, column j at phi = -pi + (j + 0.5) * 2 pi / columns.
struct LimbMap {
  double s_low = 0, step = 0.004;
  int rows = 0, columns = 0;
  std::vector<double> radius;  // rows * columns, m, outermost; NaN where there is no data
  std::vector<Vec3> colour;    // the same, 0..1; empty without colours
  std::vector<int> count;      // samples in the cell

  bool has(int i, int j) const { return count[index(i, j)] > 0; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(((j % columns) + columns) % columns);
  }
  double row_s(double i) const { return s_low + (i + 0.5) * step; }
  double row_of(double s) const { return (s - s_low) / step - 0.5; }
  double column_phi(double j) const;
  /// The column that holds the angle `phi`, radians, any turn.
  int column_of(double phi) const;
};

/// Outer radius near (s, phi), m: of the cell, of a cell up to two rows away, or between the
/// nearest cells with data round the limb, up to `reach` radians on both sides. Negative when there
/// is none.
double outer_radius(const LimbMap& map, double s, double phi, double reach = 0.0);

/// Bins the samples `members` whose normal and the direction away from the axis have a cosine of at
/// least `min_facing`; in each cell those within 6 mm of the outermost one are averaged.
LimbMap make_limb_map(const SurfaceSamples& samples, const std::vector<int>& members,
                      const LimbAxis& axis, double s_low, double s_high, double step, int columns,
                      double min_facing = 0.3);

/// One limb of a body as placement and measurements see it.
struct LimbView {
  LimbAxis axis;
  LimbMap map;               // outer surface facing away from the axis
  std::vector<int> members;  // samples on the limb, whatever their normal
};

}  // namespace regarment
