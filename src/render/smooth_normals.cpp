#include "render/smooth_normals.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

using Normal = std::array<std::int16_t, 2>;

// Moving averages along a line of pixels `stride` apart, within runs of continuous depth.
class LineFilter {
 public:
  LineFilter(GeometryBuffers& buffers, int radius, float depth_step)
      : buffers_(buffers),
        radius_(radius),
        depth_step_(depth_step),
        sums_(std::size_t(std::max(buffers.width, buffers.height)) + 1) {}

  void filter(std::size_t first, std::size_t stride, int count) {
    int begin = 0;
    while (begin < count) {
      int end = begin + 1;
      if (buffers_.id[first + begin * stride] != 0) {
        while (end < count && runs_on(first + (end - 1) * stride, first + end * stride)) ++end;
        average(first + begin * stride, stride, end - begin);
      }
      begin = end;
    }
  }

 private:
  bool runs_on(std::size_t here, std::size_t next) const {
    return buffers_.id[next] != 0 &&
           std::abs(buffers_.depth[next] - buffers_.depth[here]) < depth_step_;
  }

  void average(std::size_t first, std::size_t stride, int count) {
    std::array<int, 2> sum = {0, 0};
    for (int i = 0; i < count; ++i) {
      sums_[std::size_t(i)] = sum;
      const Normal& n = buffers_.normal[first + i * stride];
      sum[0] += n[0], sum[1] += n[1];
    }
    sums_[std::size_t(count)] = sum;
    for (int i = 0; i < count; ++i) {
      const int low = std::max(i - radius_, 0), high = std::min(i + radius_ + 1, count);
      const auto &a = sums_[std::size_t(low)], &b = sums_[std::size_t(high)];
      buffers_.normal[first + i * stride] = {
          static_cast<std::int16_t>((b[0] - a[0]) / (high - low)),
          static_cast<std::int16_t>((b[1] - a[1]) / (high - low))};
    }
  }

  GeometryBuffers& buffers_;
  int radius_;
  float depth_step_;
  std::vector<std::array<int, 2>> sums_;  // before each pixel of the run; 16 bits * 8192 fit
};

}  // namespace

void smooth_normals(GeometryBuffers& buffers, double radius, double depth_step) {
  // Two passes of half the radius weigh near neighbours more than far ones.
  const int half = std::clamp(int(std::lround(0.5 * radius)), 1, 64);
  LineFilter line(buffers, half, static_cast<float>(depth_step));
  const auto width = std::size_t(buffers.width);
  for (int pass = 0; pass < 2; ++pass) {
    for (int y = 0; y < buffers.height; ++y) line.filter(std::size_t(y) * width, 1, buffers.width);
    for (int x = 0; x < buffers.width; ++x) line.filter(std::size_t(x), width, buffers.height);
  }
}

}  // namespace regarment
