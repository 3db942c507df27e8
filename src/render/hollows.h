#pragma once

#include <cstdint>
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

  /// Chooses the row of pixels that `depth_around` answers for.
  void set_row(int y);

  /// Mean depth round the pixel in column `x` of the row set, m, interpolated between blocks.
  float depth_around(std::size_t x) const {
    const Column& c = columns_[x];
    return line_[c.block] + c.share * (line_[c.block + 1] - line_[c.block]);
  }

 private:
  struct Column {
    std::uint32_t block;  // to the left of the pixel
    float share;          // of the next block
  };

  int width_, height_;           // blocks
  std::vector<Column> columns_;  // one per column of pixels
  std::vector<float> line_;      // the row of blocks at the row set; one more at the end
  std::vector<float> mean_;      // per block, m
};

}  // namespace regarment
