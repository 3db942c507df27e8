#pragma once

#include <vector>

#include "analysis/analysis.h"
#include "base/progress.h"
#include "placement/placement_file.h"

namespace regarment {

struct AnalyzeOptions {
  PlacementOverrides placement;  // what a person said about landmarks and edges
  // Length of the sides of the pattern's triangles, m. Smaller follows folds closer and costs time.
  double pattern_edge_length = 0.025;
  // Greatest distance between samples on a mesh, m. Smaller sees finer edges and costs time.
  double sample_spacing = 0.006;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// Finds the garments of `templates` (outermost first) on a scan by the direct method: edges on the
/// scan itself, lengths between them, labels of what lies inside; no cloth is simulated.
/// Throws NoPersonError, NoGarmentError with the evidence, UsageError for an empty list or more
/// than 8 garments, Stopped when progress says so.
Analysis analyze(Scan scan, const std::vector<GarmentTemplate>& templates,
                 const AnalyzeOptions& options = {}, const Progress& progress = {});

}  // namespace regarment
