#include <algorithm>
#include <cmath>

#include "analysis/stage.h"
#include "base/error.h"
#include "fit/fit_garment.h"
#include "garment/hold_dimensions.h"
#include "segmentation/caps.h"
#include "segmentation/segment_by_distance.h"

namespace regarment {
namespace {

/// The garment's open edges, drawn to where they were found on the scan; those that another garment
/// covers are free.
std::vector<HeldEdge> held_edges(const GarmentAnalysis& garment) {
  std::vector<HeldEdge> out;
  for (const EdgeCurve& curve : garment.edges) {
    if (curve.evidence == "covered" || curve.points.size() < 3) continue;
    HeldEdge edge{{}, curve.points};
    for (const int vertex : edge_named(garment.pattern, curve.name).vertices)
      edge.particles.push_back(garment.pattern.particle[static_cast<std::size_t>(vertex)]);
    out.push_back(std::move(edge));
  }
  return out;
}

// An evaluation this near to the smallest error, as a share of it, might as well be the answer.
constexpr double kAsGood = 1.05;
// Half of a 90 % interval from the mean absolute error the paper prints for its skirts, 2.9 cm,
// were errors normal: 1.645 sqrt(pi / 2) 2.9 cm. What the search cannot know of itself.
constexpr double kPublishedHalf = 0.0598;

/// The dimensions with their intervals: where evaluations of any run are nearly as good as the
/// best, and never narrower than what was published of the method. What no length seen on the scan
/// speaks of, such as a waist under a T-shirt, is not observable whatever the search came to.
std::vector<Measurement> measurements_of(const GarmentTemplate& garment, const GarmentFit& fit,
                                         const std::map<std::string, SolvedDimension>& seen,
                                         const Dimensions& fixed) {
  std::vector<Measurement> out;
  for (std::size_t k = 0; k < garment.dimensions().size(); ++k) {
    const Dimension& d = garment.dimensions()[k];
    Measurement m;
    m.name = d.name, m.code = d.code;
    m.flat = m.low = m.high = fit.dimensions.at(d.name);
    m.fixed = fixed.contains(d.name);
    if (m.fixed) {
      out.push_back(m);
      continue;
    }
    m.low = m.flat - kPublishedHalf, m.high = m.flat + kPublishedHalf;
    for (const FitRun& run : fit.trace.runs)
      for (std::size_t e = 0; e < run.evaluations.size(); ++e) {
        const FitEvaluation& evaluation = run.evaluations[e];
        if (e != run.best && evaluation.error > kAsGood * fit.error) continue;
        m.low = std::min(m.low, evaluation.dimensions[k]);
        m.high = std::max(m.high, evaluation.dimensions[k]);
      }
    m.low = std::max(m.low, d.lower), m.high = std::min(m.high, d.upper);
    m.observable = seen.at(d.name).observable;
    if (!m.observable) m.low = d.lower, m.high = d.upper;
    out.push_back(m);
  }
  return out;
}

/// How strongly each part of the scan attracts: what was found to be an outer garment's less. Empty
/// when there is none.
std::vector<float> shares_left(const Scan& scan, const Labels& labels, double attenuation) {
  const auto outer = [&](std::size_t v) { return v < labels.label.size() && labels.label[v] != 0; };
  const auto left = static_cast<float>(attenuation);
  std::vector<float> out;
  if (std::all_of(labels.label.begin(), labels.label.end(), [](auto l) { return l == 0; }))
    return out;
  if (scan.mesh.is_cloud()) {
    for (std::size_t v = 0; v < scan.mesh.positions.size(); ++v)
      out.push_back(outer(v) ? left : 1.0F);
    return out;
  }
  for (const Triangle& t : scan.mesh.triangles)
    out.push_back(outer(t[0]) && outer(t[1]) && outer(t[2]) ? left : 1.0F);
  return out;
}

}  // namespace

GarmentAnalysis anneal_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                               Stage& stage, const Progress& progress) {
  GarmentAnalysis out;
  out.template_name = garment.name();
  out.layer = layer;
  const Dimensions& fixed = fixed_of(stage.options, garment);
  const Dimensions start = nearest_holding(garment, garment.typical(), fixed);
  out.pattern = make_pattern(garment, start, stage.options.pattern_edge_length);
  const auto [edges, cloth, observed] = look_for(garment, out.pattern, layer, stage);
  const std::vector<std::uint8_t> caps =
      stage.options.cap_detection ? find_caps(scan, edges) : std::vector<std::uint8_t>{};
  out.placed = place_garment(out.pattern, placement_target(edges, out.pattern));
  out.edges = edge_curves(edges);

  const FitTarget target(scan.mesh, masked_parts(scan, caps), kCloudSpacing * scan.facts.spacing,
                         stage.options.fit.silhouette_size,
                         shares_left(scan, stage.labels, stage.options.layer_attenuation));
  FitOptions how = stage.options.fit;
  how.fixed = fixed;
  const GarmentFit fit = fit_garment(
      garment, start, out.pattern, out.placed, target,
      stage.options.hold_edges ? held_edges(out) : std::vector<HeldEdge>{}, how, progress);
  out.dimensions = fit.dimensions;
  move_pattern(garment, out.dimensions, out.pattern);
  out.draped = fit.draped;
  out.trace = fit.trace;
  out.terms = fit.terms;
  out.measurements = measurements_of(garment, fit, solve_dimensions(garment, observed), fixed);
  judge_drape(stage, cloth, out);
  segment_by_distance(scan, out.pattern, out.draped, stage.options.segment_distance, layer,
                      stage.labels);
  out.deviation = deviation_of(scan, out, stage.labels);
  take(stage, cloth, caps, out);
  warn_about(garment, edges, out, stage.warnings);
  if (fit.drape.ending == DrapeEnding::StepLimit)
    stage.warnings.push_back(garment.title() +
                             ": the drape of the result had not come to rest when it was judged");
  return out;
}

}  // namespace regarment
