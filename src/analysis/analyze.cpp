#include "analysis/analyze.h"

#include <algorithm>
#include <utility>

#include "analysis/advice.h"
#include "analysis/spread.h"
#include "analysis/stage.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "garment/hold_dimensions.h"
#include "geometry/parallel.h"

namespace regarment {
namespace {

constexpr std::size_t kMostGarments = 8;

bool hangs_from_waist(const GarmentTemplate& garment) {
  constexpr double kAnyEdge = 0.1;  // m, of triangles that nobody looks at
  const std::vector<std::string> limbs =
      make_pattern(garment, garment.typical(), kAnyEdge).panel_limbs;
  return std::all_of(limbs.begin(), limbs.end(), [](const auto& limb) { return limb == "torso"; });
}

/// Per garment: does another one follow that hangs from the waist?
std::vector<bool> followed_below(const std::vector<GarmentTemplate>& templates) {
  std::vector<bool> out(templates.size(), false);
  for (std::size_t g = templates.size(); g-- > 1;)
    out[g - 1] = out[g] || hangs_from_waist(templates[g]);
  return out;
}

}  // namespace

std::string method_name(Method method) {
  switch (method) {
    case Method::Joint:
      return "joint";
    case Method::Direct:
      return "direct";
    case Method::Annealing:
      return "annealing";
  }
  return "";
}

void AnalyzeOptions::check() const {
  if (!(pattern_edge_length >= 0.005 && pattern_edge_length <= 0.2))
    throw InvalidInput("AnalyzeOptions: pattern_edge_length must lie between 0.005 and 0.2 m");
  if (!(segment_distance > 0 && segment_distance <= 1))
    throw InvalidInput("AnalyzeOptions: segment_distance must lie between 0 and 1 m");
  if (!(layer_attenuation >= 0 && layer_attenuation <= 1))
    throw InvalidInput("AnalyzeOptions: layer_attenuation must lie between 0 and 1, not " +
                       std::to_string(layer_attenuation));
  fit.check();
  if (!(sample_spacing >= 0.001 && sample_spacing <= 0.05))
    throw InvalidInput("AnalyzeOptions: sample_spacing must lie between 0.001 and 0.05 m");
}

const Dimensions& fixed_of(const AnalyzeOptions& options, const GarmentTemplate& garment) {
  static const Dimensions kNone;
  const auto found = options.fixed.find(garment.name());
  return found == options.fixed.end() ? kNone : found->second;
}

void check_fixed(const AnalyzeOptions& options, const std::vector<GarmentTemplate>& templates) {
  for (const auto& [name, dimensions] : options.fixed) {
    const auto garment = std::find_if(templates.begin(), templates.end(),
                                      [&name = name](const auto& t) { return t.name() == name; });
    if (garment == templates.end())
      throw UsageError("a dimension of " + name + " is fixed, which is not asked for");
    nearest_holding(*garment, garment->typical(), dimensions);
    if (options.method == Method::Annealing && dimensions.size() == garment->dimensions().size())
      throw UsageError("all dimensions of " + name +
                       " are fixed; leave one for --method annealing to search, or use another");
  }
}

Analysis analyze(Scan scan, const std::vector<GarmentTemplate>& templates,
                 const AnalyzeOptions& options, const Progress& progress) {
  options.check();
  if (templates.empty())
    throw UsageError("no garment asked for; give --garment NAME, outermost first");
  if (templates.size() > kMostGarments)
    throw UsageError("more than 8 garments asked for; give the visible ones");
  check_fixed(options, templates);
  if (scan.thin) {
    Analysis of_thin = analyze(scan.thin->scan, templates, options, progress);
    return spread_over(std::move(of_thin), std::move(scan));
  }
  Analysis analysis;
  analysis.method = method_name(options.method);
  analysis.fabric = options.fabric;
  Stopwatch watch;
  progress.report("place", 0.0);
  const double spacing =
      scan.mesh.is_cloud() ? kCloudSpacing * scan.facts.spacing : options.sample_spacing;
  Stage stage{options, sample_surface(scan.mesh, spacing, scan.outlier)};
  stage.taken.assign(stage.samples.size(), 0);
  stage.another_below = followed_below(templates);
  progress.report("place", 0.3);
  stage.body = find_body(stage.samples, scan.facts.height);
  apply_landmarks(options.placement, stage.body);
  for (Finding& finding : advise(stage.body)) scan.facts.findings.push_back(std::move(finding));
  stage.parts = vertex_parts(scan, stage.samples, stage.body);
  analysis.landmarks = stage.body.landmarks();
  analysis.times.push_back({"place", watch.lap()});
  stage.cap.assign(scan.mesh.triangles.size(), 0);
  const bool annealing = options.method == Method::Annealing;
  const char* stage_name = annealing ? "fit" : "measure";
  for (std::size_t g = 0; g < templates.size(); ++g) {
    const int layer = static_cast<int>(g) + 1;
    progress.report(stage_name, static_cast<double>(g) / static_cast<double>(templates.size()));
    analysis.garments.push_back(options.method == Method::Annealing
                                    ? anneal_garment(scan, templates[g], layer, stage, progress)
                                : options.method == Method::Joint
                                    ? joint_garment(scan, templates[g], layer, stage, progress)
                                    : measure_garment(scan, templates[g], layer, stage));
  }
  for (std::size_t f = 0; f < stage.cap.size(); ++f)
    if (stage.cap[f])
      for (std::uint32_t v : scan.mesh.triangles[f]) stage.labels.probability[v] = 0.5F;
  run_together({[&] { judge_outlines(scan, stage.cap, analysis.garments); },
                [&] {
                  for (GarmentAnalysis& garment : analysis.garments)
                    garment.borders = border_lines(scan, stage.labels.label, garment.layer,
                                                   garment.pattern, garment.draped);
                }});
  progress.report(stage_name, 1.0);
  analysis.times.push_back({stage_name, watch.lap()});
  analysis.cap = std::move(stage.cap);
  analysis.warnings = std::move(stage.warnings);
  analysis.labels = std::move(stage.labels.label);
  analysis.label_probability = std::move(stage.labels.probability);
  analysis.scan = std::move(scan);
  return analysis;
}

}  // namespace regarment
