#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "geometry/lanes.h"
#include "geometry/mesh.h"

namespace regarment {

/// The K / 2 directions a k-DOP is bounded along: the axes, then the edges' diagonals of the cube
/// (K 18 and 26), then its corners' (K 14 and 26). Not of unit length: sums of coordinates.
template <int K>
struct KDopAxes {
  static constexpr int kCount = K / 2;
  static constexpr bool kEdges = K == 18 || K == 26;
  static constexpr bool kCorners = K == 14 || K == 26;
  static constexpr int kFirstCorner = kEdges ? 9 : 3;

  static std::array<double, kCount> project(const Vec3& p) {
    const double x = p.x(), y = p.y(), z = p.z();
    std::array<double, kCount> along;
    along[0] = x, along[1] = y, along[2] = z;
    if constexpr (kEdges) {
      along[3] = x + y, along[4] = x - y;
      along[5] = y + z, along[6] = y - z;
      along[7] = z + x, along[8] = z - x;
    }
    if constexpr (kCorners) {
      along[kFirstCorner] = x + y + z, along[kFirstCorner + 1] = x + y - z;
      along[kFirstCorner + 2] = x - y + z, along[kFirstCorner + 3] = x - y - z;
    }
    return along;
  }
};

/// Extent along each direction, as floats rounded outwards. Starts empty.
template <int K>
struct KDop {
  static constexpr int kCount = KDopAxes<K>::kCount;
  std::array<float, kCount> low, high;

  KDop() {
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
  }
  void add(const Vec3& p) {
    const std::array<double, kCount> along = KDopAxes<K>::project(p);
    for (int d = 0; d < kCount; ++d) {
      const auto near = static_cast<float>(along[d]);
      const float step = std::abs(near) * 0x1p-23F;  // half of it is lost at most
      low[d] = std::min(low[d], near - step);
      high[d] = std::max(high[d], near + step);
    }
  }
  void add(const KDop& other) {
    for (int d = 0; d < kCount; ++d) {
      low[d] = std::min(low[d], other.low[d]);
      high[d] = std::max(high[d], other.high[d]);
    }
  }
};

/// N k-DOPs side by side, one a lane.
template <int K, int N>
struct KDopLanes {
  using L = Lanes<N>;
  static constexpr int kCount = KDopAxes<K>::kCount;
  std::array<L, kCount> low, high;

  /// Where there is no k-DOP a lane holds an empty one, infinitely far from everything.
  KDopLanes() {
    low.fill(L::all(std::numeric_limits<float>::infinity()));
    high.fill(L::all(-std::numeric_limits<float>::infinity()));
  }
  void set(int lane, const KDop<K>& dop) {
    for (int d = 0; d < kCount; ++d) low[d].set(lane, dop.low[d]), high[d].set(lane, dop.high[d]);
  }

  /// A lower bound of the squared distance from a point to each: gaps along three directions that
  /// stand square to each other add up, and the best such three count. `along` is the projected
  /// point.
  L squared_gap(const std::array<float, kCount>& along) const {
    const auto gap = [&](int d) {
      const L p = L::all(along[d]);
      const L g = max(max(low[d] - p, p - high[d]), L::all(0));
      return g * g;
    };
    const L x = gap(0), y = gap(1), z = gap(2);
    L best = x + y + z;
    if constexpr (KDopAxes<K>::kEdges) {
      best = max(z + (gap(3) + gap(4)) * L::all(0.5F), best);
      best = max(x + (gap(5) + gap(6)) * L::all(0.5F), best);
      best = max(y + (gap(7) + gap(8)) * L::all(0.5F), best);
    }
    if constexpr (KDopAxes<K>::kCorners) {
      constexpr int c = KDopAxes<K>::kFirstCorner;
      const L most = max(max(gap(c), gap(c + 1)), max(gap(c + 2), gap(c + 3)));
      best = max(most * L::all(0.3333333F), best);
    }
    return best;
  }
};

}  // namespace regarment
