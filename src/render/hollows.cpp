#include "render/hollows.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

// Weighted depth and weight of a block.
struct Sum {
  float depth = 0, weight = 0;
};

std::vector<Sum> sum_blocks(const GeometryBuffers& buffers, int width, int height) {
  std::vector<Sum> blocks(std::size_t(width) * height);
  for (int y = 0; y < buffers.height; ++y) {
    Sum* row = &blocks[std::size_t(y / Hollows::kBlock) * width];
    for (int x = 0; x < buffers.width; ++x) {
      const std::size_t i = buffers.index(x, y);
      if (buffers.id[i] == 0) continue;
      Sum& block = row[x / Hollows::kBlock];
      block.depth += buffers.depth[i];
      block.weight += 1.0F;
    }
  }
  return blocks;
}

// Moving sum along a line of `count` blocks `stride` apart.
void spread(std::vector<Sum>& blocks, std::vector<Sum>& line, std::size_t first, std::size_t stride,
            int count, int radius) {
  for (int i = 0; i < count; ++i) line[std::size_t(i)] = blocks[first + i * stride];
  Sum sum;
  for (int i = 0; i < std::min(radius, count); ++i) {
    sum.depth += line[std::size_t(i)].depth, sum.weight += line[std::size_t(i)].weight;
  }
  for (int i = 0; i < count; ++i) {
    if (i + radius < count) {
      const Sum& in = line[std::size_t(i + radius)];
      sum.depth += in.depth, sum.weight += in.weight;
    }
    if (i - radius - 1 >= 0) {
      const Sum& out = line[std::size_t(i - radius - 1)];
      sum.depth -= out.depth, sum.weight -= out.weight;
    }
    blocks[first + i * stride] = sum;
  }
}

// Where a pixel lies between the middles of blocks.
float block_place(int pixel, int blocks) {
  return std::clamp((float(pixel) + 0.5F) / Hollows::kBlock - 0.5F, 0.0F, float(blocks - 1));
}

}  // namespace

Hollows::Hollows(const GeometryBuffers& buffers, double radius)
    : width_((buffers.width + kBlock - 1) / kBlock),
      height_((buffers.height + kBlock - 1) / kBlock) {
  std::vector<Sum> blocks = sum_blocks(buffers, width_, height_);
  std::vector<Sum> line(std::size_t(std::max(width_, height_)));
  // Twice half the radius: a tent, which shows no square shapes.
  const int half = std::max(int(std::lround(0.5 * radius / kBlock)), 1);
  for (int pass = 0; pass < 2; ++pass) {
    for (int y = 0; y < height_; ++y) {
      spread(blocks, line, std::size_t(y) * width_, 1, width_, half);
    }
    for (int x = 0; x < width_; ++x) {
      spread(blocks, line, std::size_t(x), std::size_t(width_), height_, half);
    }
  }
  for (int x = 0; x < buffers.width; ++x) {
    const float u = block_place(x, width_);
    columns_.push_back({std::uint32_t(u), u - std::floor(u)});
  }
  mean_.reserve(blocks.size());
  for (const Sum& block : blocks) {
    // Sums that only rounding left behind are no surroundings.
    mean_.push_back(block.weight > 0.5F ? block.depth / block.weight : 0.0F);
  }
}

void Hollows::set_row(int y) {
  const float v = block_place(y, height_);
  const auto above = std::size_t(v) * std::size_t(width_);
  const auto below = std::min(std::size_t(v) + 1, std::size_t(height_ - 1)) * std::size_t(width_);
  const float down = v - std::floor(v);
  line_.resize(std::size_t(width_) + 1);
  for (std::size_t i = 0; i < std::size_t(width_); ++i) {
    line_[i] = mean_[above + i] + down * (mean_[below + i] - mean_[above + i]);
  }
  line_[std::size_t(width_)] = line_[std::size_t(width_ - 1)];
}

}  // namespace regarment
