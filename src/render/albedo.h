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

/// The colours of labels, dark lines where labels meet, stripes on caps. `pixel_labels` as above;
/// `cap`: one per triangle of the original mesh, or empty; `line` is the width of lines in pixels.
Albedo label_albedo(const Surface& surface, std::span<const std::uint8_t> pixel_labels,
                    std::span<const std::uint8_t> cap, int line);

}  // namespace regarment
