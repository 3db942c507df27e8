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

  /// Mean depth round each pixel of a row, m, interpolated between blocks. `row` has as many
  /// entries as the buffers have columns.
  void depths_around(int y, std::vector<float>& row);

 private:
  int width_, height_;       // blocks
  std::vector<float> line_;  // one row of blocks, interpolated downwards
  std::vector<float> mean_;  // per block, m
};

}  // namespace regarment
