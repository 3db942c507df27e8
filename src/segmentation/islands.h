#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/minimum_cut.h"

namespace regarment {

/// Gives small islands the label of what surrounds them: pieces of one label, connected by `links`,
/// of fewer than `least` vertices, most of which are open to doubt (`open`, one mark per vertex,
/// 1 = in doubt). A vertex without links is its own piece and stays as it is. `label`: 0 or 1 per
/// vertex. Throws InvalidInput for sizes that do not match and links beyond the vertices.
void remove_islands(std::span<const CutLink> links, std::span<const std::uint8_t> open,
                    std::size_t least, std::vector<std::uint8_t>& label);

}  // namespace regarment
