#pragma once

#include "analysis/analysis.h"
#include "fill/fill_scan.h"

namespace regarment {

/// The scan of an analysis with its holes under the garments closed by the garments found. Body
/// frame, m.
FilledScan close_holes(const Analysis& analysis);

/// Number of vertices that were added.
std::size_t count_filled(const FilledScan& filled);

}  // namespace regarment
