#include "render/floor.h"

#include <algorithm>
#include <cmath>

namespace regarment {

float FloorShadow::at(int column, int row) const {
  if (half_width <= 0.0) return 0.0F;
  const double u = (column + 0.5 - x) / half_width, v = (row + 0.5 - y) / half_height;
  const double inside = 1.0 - u * u - v * v;
  return inside > 0.0 ? static_cast<float>(0.4 * inside * inside) : 0.0F;
}

FloorShadow floor_shadow(const Surface& surface, const Camera& camera) {
  const GeometryBuffers& seen = surface.seen;
  int lowest = -1, left = seen.width, right = -1;
  const int feet = std::max(int(0.1 * camera.pixels_per_metre), 1);
  for (int y = seen.height - 1; y >= 0 && (lowest < 0 || y > lowest - feet); --y) {
    for (int x = 0; x < seen.width; ++x) {
      if (seen.id[seen.index(x, y)] == 0) continue;
      lowest = std::max(lowest, y);
      left = std::min(left, x), right = std::max(right, x);
    }
  }
  if (lowest < 0) return {};
  FloorShadow shadow;
  shadow.x = seen.left + 0.5 * (left + right + 1);
  shadow.half_width = 0.5 * (right + 1 - left) + 0.06 * camera.pixels_per_metre;
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
