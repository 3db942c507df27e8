#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/minimum_cut.h"

namespace regarment {

/// Gives small islands the label of what surrounds them: pieces of one label, connected by `links`,
/// of fewer than `least` vertices whose log-odds speak for that label by less than `firm` on
/// average. A vertex without links stays as it is. `odds`: one per vertex, > 0 speaks for label 1;
/// `label`: 0 or 1 per vertex. Throws InvalidInput for sizes that do not match and links beyond the
/// vertices.
void remove_islands(std::span<const CutLink> links, std::span<const float> odds, std::size_t least,
                    double firm, std::vector<std::uint8_t>& label);

}  // namespace regarment
