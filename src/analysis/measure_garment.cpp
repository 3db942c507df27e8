#include <algorithm>

#include "analysis/mixture.h"
#include "analysis/stage.h"
#include "garment/hold_dimensions.h"
#include "measure/garment_region.h"
#include "measure/lay_on_scan.h"
#include "measure/observe.h"
#include "segmentation/caps.h"

namespace regarment {
namespace {

constexpr double kFabricStretch = 0.05;  // tight cloth is worn up to this much longer than flat

/// Is this length a tight one, worn longer than flat? Waists, hips and whatever is measured below a
/// waist.
bool is_tight(const ObservedLength& o, const GarmentEdges& edges) {
  const auto edge = edges.edges.find(o.observation->edge);
  return edge != edges.edges.end() && edge->second.limb == "torso" && !edge->second.garment_above &&
         o.observation->kind != Observation::Kind::Path;
}

Measurement measurement_of(const Dimension& d, const SolvedDimension& solved,
                           const std::vector<ObservedLength>& observed, const GarmentEdges& edges,
                           bool fixed) {
  Measurement m;
  m.name = d.name, m.code = d.code;
  m.flat = solved.value;
  m.fixed = fixed;
  m.observable = solved.observable;
  m.low = std::max(d.lower, m.flat - kNormal90 * solved.standard_deviation);
  m.high = std::min(d.upper, m.flat + kNormal90 * solved.standard_deviation);
  if (!solved.observable) {
    m.low = d.lower, m.high = d.upper;
    return m;
  }
  double sum = 0, weight = 0;
  for (const ObservedLength& o : observed) {
    if (!o.seen || o.observation->equals != d.name) continue;
    const double w = 1 / (o.standard_deviation * o.standard_deviation);
    sum += w * o.value, weight += w;
    if (!fixed && is_tight(o, edges))
      m.low =
          std::min(m.low, m.flat * (1 - kFabricStretch) - kNormal90 * solved.standard_deviation);
  }
  if (weight > 0)
    m.worn = sum / weight;
  else if (!fixed)
    m.worn = solved.value;
  return m;
}

}  // namespace

GarmentAnalysis measure_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                                Stage& stage) {
  GarmentAnalysis out;
  out.template_name = garment.name();
  out.layer = layer;
  out.pattern = make_pattern(garment, garment.typical(), stage.options.pattern_edge_length);
  const auto [edges, cloth, observed] = look_for(garment, out.pattern, layer, stage);
  const Dimensions& fixed = fixed_of(stage.options, garment);
  const auto solved = solve_dimensions(garment, observed, fixed);
  for (const Dimension& d : garment.dimensions()) {
    out.measurements.push_back(
        measurement_of(d, solved.at(d.name), observed, edges, fixed.contains(d.name)));
    out.dimensions[d.name] = solved.at(d.name).value;
  }
  check_stays_up(garment, out.dimensions, edges, stage);
  out.dimensions = nearest_holding(garment, out.dimensions, fixed);
  move_pattern(garment, out.dimensions, out.pattern);
  out.placed = place_garment(out.pattern, placement_target(edges, out.pattern));
  out.edges = edge_curves(edges);
  std::map<std::string, std::vector<Vec3>> curves;
  for (const EdgeCurve& e : out.edges)
    if (e.evidence != "covered") curves[e.name] = e.points;
  out.draped = lay_on_scan(out.pattern, out.placed, stage.samples, cloth, curves);
  judge_drape(stage, cloth, out);
  label_region(scan, stage.parts, GarmentRegion(edges, stage.body), layer, stage.labels);
  take(stage, cloth, find_caps(scan, edges), out);
  warn_about(garment, edges, out, stage.warnings);
  return out;
}

}  // namespace regarment
