#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point_tree.h"

namespace regarment {

/// What the neighbours of each point of a cloud say about the surface there. One entry per point.
struct LocalSurface {
  static constexpr std::size_t kKept = 8;

  std::vector<Vec3> normals;  // unit, either side; of the plane through the neighbours
  std::vector<float> gap;     // mean distance to the 6 nearest points
  std::vector<std::array<std::uint32_t, kKept>>
      nearest;  // the nearest points, itself where there are fewer
};

/// Fits planes to the `neighbours` (at most 64) nearest points of every point of `points`, of which
/// `tree` was built. Fewer than 3 distinct neighbours give the normal +y.
LocalSurface local_surface(std::span<const Vec3> points, const PointTree& tree,
                           std::size_t neighbours = 16);

/// How finely and how noisily a surface was sampled.
struct SamplingQuality {
  double spacing = 0.0;  // median distance of a point to its nearest neighbour
  double noise = 0.0;    // standard deviation of points about the smooth surface near them
};

/// Measures both at the points whose indices `places` lists: a quadric is fitted to neighbours
/// enough to outweigh the noise, and what it leaves over, less its degrees of freedom, is noise
/// (with shape finer than the spacing, where points are far apart). Medians over the places. Points
/// in metres.
SamplingQuality sampling_quality(std::span<const Vec3> points, const PointTree& tree,
                                 std::span<const std::uint32_t> places);

}  // namespace regarment
