#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/heat_map.h"
#include "render/surface.h"

namespace regarment {

/// The colour of a surface before light falls on it: one entry per pixel of `Surface::seen`, black
/// where nothing is seen.
using Albedo = std::vector<Colour>;

/// Vertex colours, blended over each triangle. `colours`: one per vertex of the original mesh.
Albedo vertex_albedo(const Surface& surface, std::span<const Colour> colours);

/// `scale` over scalars, blended over each triangle; grey where a corner is NaN. `values`: one per
/// vertex of the original mesh.
Albedo value_albedo(const Surface& surface, std::span<const float> values,
                    const ColourScale& scale);

/// The label of each pixel: on a triangle with several, the one with the largest share there.
/// `kNothing` where nothing is seen. `labels`: one per vertex of the original mesh.
constexpr std::uint8_t kNothing = 255;
std::vector<std::uint8_t> pixel_labels(const Surface& surface,
                                       std::span<const std::uint8_t> labels);

/// How labels are shown. Optional parts are empty.
struct LabelPaint {
  std::span<const std::uint8_t> cap;   // per triangle of the original mesh: 1 = striped
  std::span<const float> probability;  // per vertex of it: how sure its label is
  bool borders = true;                 // dark lines where labels meet
};

/// The colours of labels, see label_colour. `pixel_labels` as above.
Albedo label_albedo(const Surface& surface, std::span<const std::uint8_t> pixel_labels,
                    const LabelPaint& paint);

}  // namespace regarment
