#pragma once

#include <vector>

#include "render/geometry_pass.h"

namespace regarment {

/// How far the surface lies behind the mean of what surrounds it, on a raster of blocks of
/// `kBlock` x `kBlock` pixels.
class Hollows {
 public:
  static constexpr int kBlock = 4;

  /// `radius` of the surroundings, pixels.
  Hollows(const GeometryBuffers& buffers, double radius);

  /// Mean depth round the pixel, m, between blocks interpolated.
  float depth_around(int x, int y) const;

 private:
  int width_, height_;
  std::vector<float> mean_;  // per block, m
};

}  // namespace regarment
