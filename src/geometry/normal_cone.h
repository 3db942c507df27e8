#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/lanes.h"
#include "geometry/mesh.h"

namespace regarment {

/// All directions within an angle of an axis. Without any: no axis.
struct NormalCone {
  Vec3 axis = Vec3::Zero();
  double cosine = 2;  // of the half angle

  /// The cone about the mean of `normals` (unit or zero; zero ones are left out). `each(visit)`
  /// calls `visit(normal)` for each of them, the same ones every time.
  template <class Each>
  static NormalCone around(Each&& each) {
    NormalCone cone;
    Vec3 sum = Vec3::Zero(), any = Vec3::Zero();
    each([&](const Vec3& normal) {
      sum += normal;
      if (!normal.isZero(0)) any = normal;
    });
    if (any.isZero(0)) return cone;
    cone.axis = sum.norm() > 1e-9 ? sum.normalized() : any;
    cone.cosine = 1;
    each([&](const Vec3& normal) {
      if (!normal.isZero(0)) cone.cosine = std::min(cone.cosine, cone.axis.dot(normal));
    });
    return cone;
  }
};

/// What a normal filter asks of a direction, as floats.
struct DirectionTest {
  std::array<float, 3> normal{};
  float length = 0;
  float least = 0;  // what floats find below this does not pass
  float sure = 0;   // and above this does

  DirectionTest(const Vec3& wanted, double min_cosine) : length(static_cast<float>(wanted.norm())) {
    for (int axis = 0; axis < 3; ++axis) normal[axis] = static_cast<float>(wanted[axis]);
    // Normals count as unit up to 1e-4; the rest of the margin is for floats.
    const double margin = 2e-4 * std::max(1.0, wanted.norm());
    least = static_cast<float>(min_cosine - margin);
    sure = static_cast<float>(min_cosine + margin);
  }

  template <int N>
  Lanes<N> cosine(const Lanes<N>& x, const Lanes<N>& y, const Lanes<N>& z) const {
    using L = Lanes<N>;
    return L::all(normal[0]) * x + L::all(normal[1]) * y + L::all(normal[2]) * z;
  }
};

/// N cones side by side, one a lane.
template <int N>
struct alignas(64) ConeLanes {
  using L = Lanes<N>;
  L x = L::all(0), y = x, z = x, cosine = L::all(2);

  void set(int lane, const NormalCone& cone) {
    x.set(lane, static_cast<float>(cone.axis.x()));
    y.set(lane, static_cast<float>(cone.axis.y()));
    z.set(lane, static_cast<float>(cone.axis.z()));
    // Smaller by what a float loses: a sine near 0 hangs on the cosine's last digits.
    cosine.set(lane, static_cast<float>(cone.cosine - 1e-6));
  }

  /// Bit i: cone i may hold a direction that passes. The direction of a cone nearest to the wanted
  /// one is that one itself, or at the rim, where the cosine is cos(angle - half angle).
  unsigned may_pass(const DirectionTest& test) const {
    const L c = test.cosine(x, y, z);
    const L s = sqrt(max(L::all(test.length * test.length) - c * c, L::all(0)));
    const L sine = sqrt(max(L::all(1) - cosine * cosine, L::all(0)));
    const unsigned inside = not_above(cosine * L::all(test.length), c);
    return inside | not_above(L::all(test.least), c * cosine + s * sine);
  }
};

}  // namespace regarment
