#pragma once

#include "render/camera.h"
#include "render/linear_colour.h"
#include "render/surface.h"

namespace regarment {

/// The soft shadow under what stands on the floor: an ellipse as wide as the lowest part of the
/// surface.
struct FloorShadow {
  double x = 0, y = 0, half_width = 0, half_height = 0;  // pixels of the supersampled picture

  /// How dark it is at a pixel, 0..0.4.
  float at(int column, int row) const;
};

/// Fits the shadow to the lowest tenth of a metre of what is seen. Nothing seen: no shadow.
FloorShadow floor_shadow(const Surface& surface, const Camera& camera);

/// Draws a bar of 20 cm in four blocks of 5 cm at the lower left of a picture.
void draw_scale_bar(Image& image, double pixels_per_metre);

}  // namespace regarment
