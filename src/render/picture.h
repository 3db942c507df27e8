#pragma once

#include <vector>

#include "render/floor.h"
#include "render/image.h"
#include "render/paint.h"
#include "render/strokes.h"

namespace regarment {

/// Each pixel of a picture is the mean of this many by this many samples.
constexpr int kSamples = 2;

/// Paints surfaces, the first at the back, and lines on them over a shadow and a background.
/// `camera` is the supersampled one, by kSamples. `shadow` may be null.
Image paint_picture(const Camera& camera, const std::vector<Paint>& paints, const Strokes& lines,
                    const FloorShadow* shadow, Rgba background);

}  // namespace regarment
