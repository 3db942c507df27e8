#pragma once

#include <cstdint>
#include <vector>

#include "scan/scan.h"

namespace regarment {

/// Adds to the log-odds of cloth (one per vertex) what colours say: histograms of garment and
/// person learnt from vertices whose odds are beyond 2.5 either way, weighted by how well they tell
/// these apart; at most 4. Nothing for vertices marked in `skip`, for a scan without colours, with
/// fewer than 500 such vertices of either kind, or whose colours do not tell them apart.
void add_colour_odds(const Scan& scan, const std::vector<std::uint8_t>& skip,
                     std::vector<float>& odds);

}  // namespace regarment
