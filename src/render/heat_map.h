#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "render/image.h"

namespace regarment {

/// Perceptually even colour scales that people with any colour vision can read.
enum class Palette {
  Diverging,  // dark blue - pale - dark red-brown; for signed values, lightest at zero
  Viridis,    // dark violet - green - yellow; for values from small to large
};

/// Colour at `t` in 0..1 (clamped). NaN gives `no_data_colour()`.
Colour palette_colour(Palette palette, double t);

/// The grey of places where there is no data.
Colour no_data_colour();

/// Which values a palette spans.
struct ColourScale {
  Palette palette = Palette::Diverging;
  double low = -0.01, high = 0.01;  // in the unit of the values; low < high

  Colour colour(double value) const;
};

/// A scale for signed values, symmetric about zero. `range` > 0.
ColourScale symmetric_scale(double range);

/// A range for signed values: the 95th percentile of |value|, rounded up to 1, 2 or 5 times a power
/// of ten. NaN is left out. Returns `fallback` when there are no values or all are zero.
double symmetric_range(const std::vector<float>& values, double fallback = 0.01);

/// The colour bar for a legend, `low` at the left. Plain colours, no text.
Image colour_bar(const ColourScale& scale, int width, int height);

/// The colour of a garment in every figure and legend: 1 = outermost. Colour-blind safe for the
/// first six; repeats after that. 0 gives the person's neutral colour.
Colour garment_colour(int layer);

/// What is mixed into a label's colour where the label is not sure.
Colour unsure_colour();

/// The colour of a label (0 person, i = i-th garment) that is right with this probability: the
/// garment's own where it is sure, nearly all `unsure_colour()` at one half.
Colour label_colour(int label, float probability);

/// The lines along a garment's border.
Colour border_colour();

/// "#rrggbb".
std::string css_colour(Colour colour);

}  // namespace regarment
