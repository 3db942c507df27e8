#include "render/smooth_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace regarment {
namespace {

using Normal = std::array<std::int16_t, 2>;

// A line of neighbouring pixels.
struct Line {
  const std::uint32_t* id;
  const float* depth;
  Normal* normal;
  int count;
};

// Moving averages along lines, within runs of continuous depth.
class LineFilter {
 public:
  LineFilter(int longest, int radius, float depth_step)
      : radius_(radius), depth_step_(depth_step), sums_(std::size_t(longest) + 1) {}

  void filter(const Line& line) {
    int begin = 0;
    while (begin < line.count) {
      int end = begin + 1;
      if (line.id[begin] != 0) {
        while (end < line.count && line.id[end] != 0 &&
               std::abs(line.depth[end] - line.depth[end - 1]) < depth_step_) {
          ++end;
        }
        average(line.normal + begin, end - begin);
      }
      begin = end;
    }
  }

 private:
  void average(Normal* normal, int count) {
    std::array<int, 2> sum = {0, 0};
    for (int i = 0; i < count; ++i) {
      sums_[std::size_t(i)] = sum;
      sum[0] += normal[i][0], sum[1] += normal[i][1];
    }
    sums_[std::size_t(count)] = sum;
    for (int i = 0; i < count; ++i) {
      const int low = std::max(i - radius_, 0), high = std::min(i + radius_ + 1, count);
      const auto &a = sums_[std::size_t(low)], &b = sums_[std::size_t(high)];
      const float share = 1.0F / float(high - low);
      normal[i] = {static_cast<std::int16_t>(float(b[0] - a[0]) * share),
                   static_cast<std::int16_t>(float(b[1] - a[1]) * share)};
    }
  }

  int radius_;
  float depth_step_;
  std::vector<std::array<int, 2>> sums_;  // before each pixel of the run; 16384 of 16 bits fit
};

void filter_rows(GeometryBuffers& buffers, LineFilter& filter) {
  for (int y = 0; y < buffers.height; ++y) {
    const std::size_t first = buffers.index(0, y);
    filter.filter(
        {&buffers.id[first], &buffers.depth[first], &buffers.normal[first], buffers.width});
  }
}

// Columns are laid out as lines, a strip of them at a time: walking down the picture pixel by pixel
// would wait for memory at each.
void filter_columns(GeometryBuffers& buffers, LineFilter& filter) {
  constexpr int kStrip = 16;
  const auto height = std::size_t(buffers.height);
  std::vector<std::uint32_t> id(kStrip * height);
  std::vector<float> depth(kStrip * height);
  std::vector<Normal> normal(kStrip * height);
  for (int left = 0; left < buffers.width; left += kStrip) {
    const auto columns = std::size_t(std::min(kStrip, buffers.width - left));
    for (std::size_t y = 0; y < height; ++y) {
      const std::size_t from = buffers.index(left, int(y));
      for (std::size_t c = 0; c < columns; ++c) {
        id[c * height + y] = buffers.id[from + c];
        depth[c * height + y] = buffers.depth[from + c];
        normal[c * height + y] = buffers.normal[from + c];
      }
    }
    for (std::size_t c = 0; c < columns; ++c) {
      filter.filter({&id[c * height], &depth[c * height], &normal[c * height], buffers.height});
    }
    for (std::size_t y = 0; y < height; ++y) {
      const std::size_t to = buffers.index(left, int(y));
      for (std::size_t c = 0; c < columns; ++c) buffers.normal[to + c] = normal[c * height + y];
    }
  }
}

}  // namespace

void smooth_normals(GeometryBuffers& buffers, double radius, double depth_step) {
  if (buffers.id.empty()) return;
  // Two passes of half the radius weigh near neighbours more than far ones.
  const int half = std::clamp(int(std::lround(0.5 * radius)), 1, 64);
  LineFilter filter(std::max(buffers.width, buffers.height), half, static_cast<float>(depth_step));
  for (int pass = 0; pass < 2; ++pass) {
    filter_rows(buffers, filter);
    filter_columns(buffers, filter);
  }
}

}  // namespace regarment
