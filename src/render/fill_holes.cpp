#include "render/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace regarment {
namespace {

struct HoleFiller {
  const GeometryBuffers& seen;
  int reach;
  float depth_step;

  bool alike(std::size_t a, std::size_t b) const {
    return std::abs(seen.depth[a] - seen.depth[b]) < depth_step;
  }

  // Pixels in short gaps of their column.
  std::vector<std::pair<int, int>> short_column_gaps() const {
    std::vector<std::pair<int, int>> gaps;
    std::vector<int> last(std::size_t(seen.width), -1);  // row last covered, per column
    for (int y = 0; y < seen.height; ++y) {
      for (int x = 0; x < seen.width; ++x) {
        if (seen.id[seen.index(x, y)] == 0) continue;
        int& before = last[std::size_t(x)];
        const int gap = y - before - 1;
        if (before >= 0 && gap > 0 && gap < reach &&
            alike(seen.index(x, before), seen.index(x, y))) {
          for (int row = before + 1; row < y; ++row) gaps.emplace_back(x, row);
        }
        before = y;
      }
    }
    return gaps;
  }

  // Steps from the pixel to the first covered one in a direction; more than `reach`: none.
  int steps_to_cover(int x, int y, int dx, int dy) const {
    for (int n = 1; n <= reach; ++n) {
      const int u = x + n * dx, v = y + n * dy;
      if (u < 0 || v < 0 || u >= seen.width || v >= seen.height) break;
      if (seen.id[seen.index(u, v)] != 0) return n;
    }
    return reach + 1;
  }

  // The pixel to copy from; its own index when it stays empty.
  std::size_t model_of(int x, int y) const {
    const std::size_t own = seen.index(x, y);
    const int left = steps_to_cover(x, y, -1, 0), right = steps_to_cover(x, y, 1, 0);
    if (left > reach || right > reach) return own;
    const std::size_t from_left = seen.index(x - left, y), from_right = seen.index(x + right, y);
    if (!alike(from_left, from_right)) return own;
    const int up = steps_to_cover(x, y, 0, -1), down = steps_to_cover(x, y, 0, 1);
    const int nearest = std::min({left, right, up, down});
    if (nearest == left) return from_left;
    if (nearest == right) return from_right;
    return nearest == up ? seen.index(x, y - up) : seen.index(x, y + down);
  }
};

}  // namespace

void fill_holes(GeometryBuffers& buffers, int reach, double depth_step) {
  const HoleFiller filler{buffers, reach, static_cast<float>(depth_step)};
  std::vector<std::pair<std::size_t, std::size_t>> copies;  // to, from
  for (const auto& [x, y] : filler.short_column_gaps()) {
    const std::size_t to = buffers.index(x, y), from = filler.model_of(x, y);
    if (from != to) copies.emplace_back(to, from);
  }
  for (const auto& [to, from] : copies) {
    buffers.id[to] = buffers.id[from];
    buffers.depth[to] = buffers.depth[from];
    buffers.normal[to] = buffers.normal[from];
  }
}

}  // namespace regarment
