#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "base/progress.h"
#include "fill/fill_scan.h"
#include "report/result.h"

namespace regarment {

/// Pictures of an analysis: what each shows, and its bytes by StoredFigure::file.
struct Pictures {
  std::vector<StoredFigure> figures;
  std::map<std::string, std::string> bytes;
};

/// Draws the scan, its segmentation, the placement, the garments on the scan, where a method tells
/// it how far the scan lies from them, and where holes were closed (`filled`) what closes them,
/// each from four sides at one scale, so that pictures of one side lie exactly over each other. At
/// most 900 KB in all, 2.2 MB at a `pixel_ratio` of 2, for fine screens and printing. The same
/// bytes for any number of `threads` (>= 1). Reports progress as the stage "draw".
Pictures draw_pictures(const Analysis& analysis, const FilledScan& filled, int pixel_ratio,
                       int threads, const Progress& progress);

}  // namespace regarment
