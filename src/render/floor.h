#pragma once

#include <vector>

#include "render/camera.h"
#include "render/linear_colour.h"
#include "render/surface.h"

namespace regarment {

/// The soft shadow on the floor under what stands on it.
struct FloorShadow {
  std::vector<float> column;  // per column of the supersampled picture: 0 none .. 1 under a foot
  double y = 0;               // row of its middle
  double half_height = 0;     // rows; 0 = no shadow

  /// How dark the row is where `column` is 1, 0..0.45.
  float strength(int row) const;
};

/// Found from the lowest 6 cm of what is seen. Nothing seen: no shadow.
FloorShadow floor_shadow(const Surface& surface, const Camera& camera);

/// Draws a bar of 20 cm in four blocks of 5 cm at the lower left of a picture.
void draw_scale_bar(Image& image, double pixels_per_metre);

}  // namespace regarment
