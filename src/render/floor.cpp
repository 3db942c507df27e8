#include "render/floor.h"

#include <algorithm>
#include <cmath>

namespace regarment {

namespace {

// The last row that shows anything, or -1.
int lowest_row(const GeometryBuffers& seen) {
  for (std::size_t i = seen.id.size(); i-- > 0;) {
    if (seen.id[i] != 0) return int(i / std::size_t(seen.width));
  }
  return -1;
}

// Moving mean over `radius` columns each way.
std::vector<float> soften(const std::vector<float>& sharp, int radius) {
  std::vector<double> sum(sharp.size() + 1, 0.0);
  for (std::size_t i = 0; i < sharp.size(); ++i) sum[i + 1] = sum[i] + double(sharp[i]);
  const int count = int(sharp.size());
  std::vector<float> soft;
  for (int i = 0; i < count; ++i) {
    const double inside = sum[std::size_t(std::min(i + radius + 1, count))] -
                          sum[std::size_t(std::max(i - radius, 0))];
    soft.push_back(static_cast<float>(inside / (2 * radius + 1)));
  }
  return soft;
}

}  // namespace

float FloorShadow::strength(int row) const {
  if (half_height <= 0.0) return 0.0F;
  const double v = (row + 0.5 - y) / half_height;
  const double inside = std::max(1.0 - v * v, 0.0);
  return static_cast<float>(0.45 * inside * inside);
}

FloorShadow floor_shadow(const Surface& surface, const Camera& camera) {
  const GeometryBuffers& seen = surface.seen;
  const int lowest = lowest_row(seen);
  if (lowest < 0) return {};
  FloorShadow shadow;
  shadow.column.assign(std::size_t(camera.width), 0.0F);
  const int feet = std::max(int(0.06 * camera.pixels_per_metre), 1);
  for (int y = std::max(lowest - feet + 1, 0); y <= lowest; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      if (seen.id[seen.index(x, y)] != 0) shadow.column[std::size_t(x + seen.left)] = 1.0F;
    }
  }
  const int soft = std::max(int(0.03 * camera.pixels_per_metre), 1);
  shadow.column = soften(soften(shadow.column, soft), soft);
  shadow.half_height = std::max(0.02 * camera.pixels_per_metre, 1.0);
  shadow.y = seen.top + lowest + 1 - 0.25 * shadow.half_height;
  return shadow;
}

void draw_scale_bar(Image& image, double pixels_per_metre) {
  constexpr Rgba kDark = {60, 63, 70, 255}, kLight = {235, 236, 238, 255};
  const double block = 0.05 * pixels_per_metre;
  const int thickness = std::max(image.height / 150, 3);
  const int left = image.width / 40 + 1, top = image.height - 2 * thickness - left / 2;
  const int right = std::min(int(std::lround(left + 4.0 * block)), image.width);
  for (int y = std::max(top, 0); y < std::min(top + thickness, image.height); ++y) {
    for (int x = left; x < right; ++x) {
      const bool frame = y == top || y == top + thickness - 1 || x == left || x == right - 1;
      const bool even = int((x - left) / block) % 2 == 0;
      image.at(x, y) = frame || even ? kDark : kLight;
    }
  }
}

}  // namespace regarment
