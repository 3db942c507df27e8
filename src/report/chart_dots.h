#pragma once

#include <cstddef>
#include <vector>

namespace regarment {

/// Which values to draw as dots, in order: all that are numbers, or about `most` (>= 2) of them:
/// the smallest and the largest of each of equal stretches, so that no outlier is lost.
std::vector<std::size_t> dots_to_draw(const std::vector<double>& values, std::size_t most);

}  // namespace regarment
