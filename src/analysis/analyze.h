#pragma once

#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "base/progress.h"
#include "fit/fit_garment.h"
#include "placement/placement_file.h"

namespace regarment {

/// How dimensions are found.
enum class Method {
  Direct,     // measured on the scan itself
  Annealing,  // Hasler et al. 2007: a garment draped again and again
};

/// "direct", "annealing".
std::string method_name(Method method);

struct AnalyzeOptions {
  Method method = Method::Direct;
  FitOptions fit;  // of Method::Annealing
  // Scan this near to the draped garment is labelled as garment by Method::Annealing, m [Hasler et
  // al. 2007, sec. 3.5]. Larger takes in more of the skin beside the edges.
  double segment_distance = 0.01;
  // The garment's open edges are drawn to where they show on the scan; false: they slide as in the
  // paper, and lengths are hardly held by anything.
  bool hold_edges = true;
  // Surface invented under a hem is found and left out of the fit; false: it attracts (Fig. 5).
  bool cap_detection = true;
  PlacementOverrides placement;  // what a person said about landmarks and edges
  // Length of the sides of the pattern's triangles, m. Smaller follows folds closer and costs time.
  double pattern_edge_length = 0.025;
  // Greatest distance between samples on a mesh, m. Smaller sees finer edges and costs time.
  double sample_spacing = 0.006;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// Finds the garments of `templates` (outermost first) on a scan.
/// Throws NoPersonError, NoGarmentError with the evidence, UsageError for an empty list or more
/// than 8 garments, Stopped when progress says so.
Analysis analyze(Scan scan, const std::vector<GarmentTemplate>& templates,
                 const AnalyzeOptions& options = {}, const Progress& progress = {});

}  // namespace regarment
