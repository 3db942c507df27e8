#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "scan/find_up.h"

namespace regarment {

/// Between the file's frame and a person's own: metres, +x to the left, +y up, +z ahead.
struct BodyFrame {
  Eigen::Matrix3d turn;  // rows: left, up and ahead in the file's frame
  double metres = 1.0;   // one file unit, m
  Vec3 origin;           // in the file's frame

  Vec3 from_file(const Vec3& p) const { return turn * (p - origin) * metres; }
  Eigen::Affine3d to_file() const;
};

/// Points in body heights with the floor at 0, +y up, x and z any two horizontal directions; for
/// looking at a person whose front is not known yet.
class UprightView {
 public:
  explicit UprightView(const UpAxis& up);

  std::vector<Vec3> from_file(std::span<const Vec3> points) const;
  Vec3 direction_in_file(const Vec3& direction) const { return turn_.transpose() * direction; }

 private:
  Eigen::Matrix3d turn_;
  double low_, height_;
};

/// Where a body begins and ends, m.
struct Reach {
  double floor = 0.0, top = 0.0;
};

/// Heights that hardly any of the surface lies below and above: 0.3 and 0.2 thousandths, which is
/// noise. Each position counts with the area of its triangles, in a cloud all alike. `stray`
/// positions are left out.
Reach find_reach(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                 std::span<const std::uint8_t> stray);

}  // namespace regarment
