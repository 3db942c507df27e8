#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "geometry/lanes.h"
#include "geometry/normal_cone.h"
#include "geometry/surface_element.h"

namespace regarment {

/// What floats of a tree count from, and how far from there they are good for bounds. Elements
/// that reach farther, strays, get no number, which every bound passes; boxes keep them apart.
struct FloatFrame {
  Vec3 centre = Vec3::Zero();
  double reach = 0;  // along each axis

  bool holds(const Vec3& from_centre) const { return from_centre.cwiseAbs().maxCoeff() <= reach; }
};

/// Triangles side by side as floats, good for a lower bound of the squared distance to each: a
/// triangle lies in its plane and behind the three planes square to it through its edges. The bound
/// is exact but beyond the corners.
struct alignas(64) TriangleBlock {
  static constexpr int kSize = 4;
  using L = Lanes<kSize>;

  struct Plane {
    L x, y, z, offset;

    L height(const std::array<float, 3>& p) const {
      return x * L::all(p[0]) + y * L::all(p[1]) + z * L::all(p[2]) - offset;
    }
    void set(int lane, const Vec3& normal) {
      x.set(lane, static_cast<float>(normal.x()));
      y.set(lane, static_cast<float>(normal.y()));
      z.set(lane, static_cast<float>(normal.z()));
    }
    // The normal as it is kept.
    Vec3 kept(int lane) const { return Eigen::Vector3f(x[lane], y[lane], z[lane]).cast<double>(); }
  };
  Plane face;
  std::array<Plane, 3> edges;

  L squared_gap(const std::array<float, 3>& p) const {
    const L up = face.height(p);
    const L out =
        max(max(edges[0].height(p), edges[1].height(p)), max(edges[2].height(p), L::all(0)));
    return max(up * up + out * out, L::all(0));  // 0 without a number
  }
  L cosine(const DirectionTest& test) const { return test.cosine(face.x, face.y, face.z); }

  /// A triangle too thin to have a good plane gets no number either.
  void set(int lane, const TriangleElements& elements, std::size_t i, const FloatFrame& frame) {
    std::array<Vec3, 3> corner = elements.corners(i);
    for (Vec3& c : corner) c -= frame.centre;
    const Vec3 normal = elements.normal(i);
    face.set(lane, normal);
    const auto [low, high] = extent(face.kept(lane), corner);
    const bool good = high - low <= frame.reach * 0x1p-22 && frame.holds(corner[0]) &&
                      frame.holds(corner[1]) && frame.holds(corner[2]);
    face.offset.set(lane, good ? static_cast<float>((low + high) / 2)
                               : std::numeric_limits<float>::quiet_NaN());
    for (int k = 0; k < 3; ++k) {
      const Vec3& from = corner[(k + 1) % 3];
      Vec3 outward = (corner[(k + 2) % 3] - from).cross(normal).normalized();
      if (outward.dot(corner[k] - from) > 0) outward = -outward;
      edges[k].set(lane, outward);
      edges[k].offset.set(lane, static_cast<float>(extent(edges[k].kept(lane), corner).second));
    }
  }

 private:
  static std::pair<double, double> extent(const Vec3& normal, const std::array<Vec3, 3>& corner) {
    return std::minmax({normal.dot(corner[0]), normal.dot(corner[1]), normal.dot(corner[2])});
  }
};

/// Points of a cloud side by side as floats; a point without a normal has no number for it.
struct alignas(64) PointBlock {
  static constexpr int kSize = 8;
  using L = Lanes<kSize>;
  L x, y, z;
  L nx, ny, nz;

  L squared_gap(const std::array<float, 3>& p) const {
    const L dx = x - L::all(p[0]), dy = y - L::all(p[1]), dz = z - L::all(p[2]);
    return max(dx * dx + dy * dy + dz * dz, L::all(0));  // 0 without a number
  }
  L cosine(const DirectionTest& test) const { return test.cosine(nx, ny, nz); }

  void set(int lane, const PointElements& elements, std::size_t i, const FloatFrame& frame) {
    Vec3 p = elements.corners(i)[0] - frame.centre;
    if (!frame.holds(p)) p.setConstant(std::numeric_limits<double>::quiet_NaN());
    Vec3 normal = elements.normal(i);
    if (normal.isZero(0)) normal.setConstant(std::numeric_limits<double>::quiet_NaN());
    x.set(lane, static_cast<float>(p.x()));
    y.set(lane, static_cast<float>(p.y()));
    z.set(lane, static_cast<float>(p.z()));
    nx.set(lane, static_cast<float>(normal.x()));
    ny.set(lane, static_cast<float>(normal.y()));
    nz.set(lane, static_cast<float>(normal.z()));
  }
};

/// The block that tests elements of a kind.
template <class Elements>
struct BlockOf;
template <>
struct BlockOf<TriangleElements> {
  using Type = TriangleBlock;
};
template <>
struct BlockOf<PointElements> {
  using Type = PointBlock;
};

}  // namespace regarment
