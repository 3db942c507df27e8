#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace regarment {

/// Two vertices of a graph and what it costs to label them differently.
struct CutLink {
  std::uint32_t a = 0, b = 0;
  float cost = 0;  // >= 0; of several links between the same two the costs add up
};

/// The labels of least energy of a graph with two labels:
///   E(x) = sum_i |odds_i| [x_i differs from the sign of odds_i] + sum_links cost [x_a != x_b].
/// `odds`: one per vertex, > 0 speaks for label 1. Returns one label per vertex, 0 or 1. The answer
/// is exact for costs rounded to thousandths, and the same everywhere; of several cuts of least
/// energy it is the one with the fewest ones. Throws InvalidInput for a link beyond the vertices, a
/// number that is not finite or above 1e4, a negative cost.
std::vector<std::uint8_t> minimum_cut(std::span<const float> odds, std::span<const CutLink> links);

}  // namespace regarment
