#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "base/progress.h"
#include "fit/fit_garment.h"
#include "garment/fabric.h"
#include "joint/joint_fit.h"
#include "placement/placement_file.h"

namespace regarment {

/// How dimensions are found.
enum class Method {
  Joint,      // particles and dimensions of a garment fitted to the scan at once
  Direct,     // measured on the scan itself
  Annealing,  // Hasler et al. 2007: a garment draped again and again
};

/// "joint", "direct", "annealing".
std::string method_name(Method method);

struct AnalyzeOptions {
  Method method = Method::Direct;
  FitOptions fit;      // of Method::Annealing
  JointOptions joint;  // of Method::Joint
  // Scan this near to the draped garment is labelled as garment by Method::Annealing, m [Hasler et
  // al. 2007, sec. 3.5]. Larger takes in more of the skin beside the edges.
  double segment_distance = 0.01;
  // The garment's open edges are drawn to where they show on the scan; false: they slide as in the
  // paper, and lengths are hardly held by anything.
  bool hold_edges = true;
  // Surface invented under a hem is found and left out of the fit; false: it attracts (Fig. 5).
  bool cap_detection = true;
  // How strongly scan that an outer garment was found on attracts the next one by
  // Method::Annealing, 0..1 [sec. 3.6]: it supports what it hides. Larger draws hidden cloth nearer
  // to the outer garment; 0: nothing holds it. Method::Joint bounds it inside instead.
  double layer_attenuation = 0.1;
  // What a person said about landmarks and edges. An edge may be named "skirt.waist", by template,
  // where the plain name would mean several garments; this counts more than the plain one.
  PlacementOverrides placement;
  // Dimensions a person knows, m, by template name: held exactly, the others fit around them.
  std::map<std::string, Dimensions> fixed;
  Fabric fabric = Fabric::Unknown;  // how far worn cloth stretches
  // Length of the sides of the pattern's triangles, m. Smaller follows folds closer and costs time.
  double pattern_edge_length = 0.025;
  // Greatest distance between samples on a mesh, m. Smaller sees finer edges and costs time.
  double sample_spacing = 0.006;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// The dimensions that are fixed for a template; empty when none are.
const Dimensions& fixed_of(const AnalyzeOptions& options, const GarmentTemplate& garment);

/// Throws UsageError when `options.fixed` names a template that is not among `templates`, holds
/// what no garment can have, or leaves a method that searches nothing to search.
void check_fixed(const AnalyzeOptions& options, const std::vector<GarmentTemplate>& templates);

/// Finds the garments of `templates` (outermost first) on a scan.
/// Throws NoPersonError, NoGarmentError with the evidence, Stopped when progress says so, and
/// UsageError for an empty list, more than 8 garments or what check_fixed() refuses.
Analysis analyze(Scan scan, const std::vector<GarmentTemplate>& templates,
                 const AnalyzeOptions& options = {}, const Progress& progress = {});

}  // namespace regarment
