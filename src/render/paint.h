#pragma once

#include <vector>

#include "render/albedo.h"
#include "render/linear_colour.h"
#include "render/surface.h"

namespace regarment {

/// One row of the supersampled picture while it is painted.
struct PaintRow {
  int y = 0;
  std::vector<Linear> colour;  // one per pixel of the row
  std::vector<float> depth;    // m, of the nearest opaque thing
};

/// How a surface is laid into a picture.
struct Paint {
  const Surface* surface = nullptr;
  Albedo albedo;  // empty: `plain` everywhere
  Colour plain = {255, 255, 255};
  float opacity = 1.0F;     // of the surface itself
  float evenness = 0.0F;    // 0: the studio's light, 1: the bare albedo, for colours to be read off
  float wire = 0.0F;        // opacity of the lines along its triangles, 0 = none
  float wire_width = 2.0F;  // pixels
  float bias = 0.0F;        // m: how far behind what is painted it still counts as in front
};

/// Paints the part of the surface that lies in the row over what is there, where it is nearer.
/// An opaque surface takes over the depth.
void paint_surface(const Paint& paint, PaintRow& row);

}  // namespace regarment
