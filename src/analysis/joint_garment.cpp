#include <algorithm>
#include <cmath>

#include "analysis/hidden_edges.h"
#include "analysis/joint_target.h"
#include "analysis/stage.h"
#include "analysis/weigh_estimates.h"
#include "base/error.h"
#include "fabric/worn_stretch.h"
#include "garment/hold_dimensions.h"
#include "joint/joint_fit.h"
#include "measure/garment_region.h"
#include "measure/lay_on_scan.h"
#include "segmentation/caps.h"
#include "segmentation/segment_by_cut.h"

namespace regarment {
namespace {

constexpr double kNormal90 = 1.645;  // half width of a 90 % interval in standard deviations
// The energy counts the scan's errors as if neighbours erred alone; lengths measured on it know
// better how far they may be off.
constexpr double kLengthTrust = 0.25;
// Of the cloth seen that lies on the fitted garment. Of 186 fits to what made people wear one has
// less than 0.8, none less than 0.7. Fits of what they do not wear have as much: this tells a fit
// that failed; the wrong garment shows in its edges.
constexpr double kLeastMatched = 0.5, kWellMatched = 0.8;
// m: what the labels make of an edge's standard error, which is that of its mean, not of each
// place.
constexpr double kLeastBorderError = 0.003, kMostBorderError = 0.02;

std::string share_text(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// What was measured on the scan holds the fit where folds could be taken for more cloth.
std::vector<MeasuredLength> lengths_of(const std::vector<ObservedLength>& observed,
                                       const std::map<std::string, HiddenEdge>& hidden) {
  std::vector<MeasuredLength> out;
  for (const ObservedLength& o : observed) {
    if (o.seen)
      out.push_back({o.observation->equals, o.value, kLengthTrust * o.standard_deviation});
    else if (const auto length = probable_length(o, hidden))
      out.push_back({o.observation->equals, length->value, length->standard_deviation});
  }
  return out;
}

/// Dimensions to start from, and the garment laid on the scan at these.
void start(const GarmentTemplate& garment, const SeenGarment& seen, const Stage& stage,
           const std::map<std::string, SolvedDimension>& solved,
           const std::map<std::string, HiddenEdge>& hidden, GarmentAnalysis& out) {
  for (const Dimension& d : garment.dimensions()) out.dimensions[d.name] = solved.at(d.name).value;
  for (const ObservedLength& o : seen.observed)
    if (const auto length = probable_length(o, hidden);
        length && out.dimensions.count(o.observation->equals) != 0)
      out.dimensions[o.observation->equals] = length->value;
  out.dimensions = nearest_holding(garment, out.dimensions, fixed_of(stage.options, garment));
  move_pattern(garment, out.dimensions, out.pattern);
  out.placed = place_garment(out.pattern, placement_target(seen.edges, out.pattern));
  out.edges = edge_curves(seen.edges);
  std::map<std::string, std::vector<Vec3>> curves;
  for (const EdgeCurve& e : out.edges)
    if (e.evidence != "covered") curves[e.name] = e.points;
  out.draped = lay_on_scan(out.pattern, out.placed, stage.samples, seen.cloth, curves);
}

/// `hidden`: where another garment hides what the dimension depends on; or null.
Measurement measurement_of(const Dimension& d, const WornEstimate& worn, const Stretch& stretch,
                           bool seen, const HiddenDimension* hidden, const Dimensions& fixed) {
  Measurement m;
  m.name = d.name, m.code = d.code;
  m.worn = worn.value;
  m.flat = std::clamp(worn.value / (1 + stretch.mean), d.lower, d.upper);
  const auto known = fixed.find(d.name);
  m.fixed = known != fixed.end();
  if (m.fixed) m.flat = m.low = m.high = known->second;
  m.observable = m.fixed || seen || (hidden && hidden->told);
  if (m.fixed) return m;
  double deviation = std::hypot(worn.standard_deviation, worn.value * stretch.standard_deviation);
  if (!seen && hidden) deviation = std::hypot(deviation, hidden->standard_deviation);
  m.low = std::max(d.lower, m.flat - kNormal90 * deviation);
  m.high = std::min(d.upper, m.flat + kNormal90 * deviation);
  if (m.observable) return m;
  m.worn.reset();
  if (hidden && hidden->standard_deviation > 0) {
    if (hidden->value) m.flat = std::clamp(*hidden->value, d.lower, d.upper);
    const double half = kNormal90 * (hidden->value ? hidden->standard_deviation : deviation);
    m.low = std::min(m.flat, std::max({d.lower, hidden->least, m.flat - half}));
    m.high = std::min(d.upper, m.flat + half);
  } else {
    m.flat = d.typical, m.low = d.lower, m.high = d.upper;
  }
  return m;
}

CutOptions cut_options(const GarmentEdges& edges) {
  CutOptions options;
  for (const auto& [name, edge] : edges.edges)
    options.edge_error[name] =
        std::clamp(edge.found.standard_error, kLeastBorderError, kMostBorderError);
  return options;
}

}  // namespace

GarmentAnalysis joint_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                              Stage& stage, const Progress& progress) {
  GarmentAnalysis out;
  out.template_name = garment.name();
  out.layer = layer;
  out.pattern = make_pattern(garment, garment.typical(), stage.options.pattern_edge_length);
  const SeenGarment seen = look_for(garment, out.pattern, layer, stage);
  const Dimensions& fixed = fixed_of(stage.options, garment);
  const auto solved = solve_dimensions(garment, seen.observed, fixed);
  const auto hidden = hidden_edges(seen.edges, stage.body);
  start(garment, seen, stage, solved, hidden, out);

  JointOptions options = stage.options.joint;
  options.fixed = fixed;
  JointTarget target = joint_target(stage.samples, seen.cloth, seen.edges, hidden);
  target.outer = stage.outer;
  JointFit fit = joint_fit(garment, out.dimensions, out.pattern, out.draped, target,
                           lengths_of(seen.observed, hidden), options, progress);
  if (fit.matched < kLeastMatched)
    throw NoGarmentError(
        "no " + garment.name() + " on this scan: only " + share_text(fit.matched) +
        " of what lies between its edges fits one; ask for the garment that is worn");
  check_stays_up(garment, fit.dimensions, seen.edges, stage);
  if (fit.matched < kWellMatched)
    stage.warnings.push_back(garment.title() + ": only " + share_text(fit.matched) +
                             " of the cloth seen lies on the fitted garment; it may be a different "
                             "garment");
  out.dimensions = fit.dimensions;
  out.pattern = std::move(fit.pattern);
  out.draped = std::move(fit.draped);
  out.placed = place_garment(out.pattern, placement_target(seen.edges, out.pattern));

  const auto sources = worn_sources(garment, fit, seen.observed);
  StretchOptions cloth;
  cloth.fabric = stage.options.fabric;
  const auto stretch = worn_stretch(garment, out.dimensions, out.pattern, out.draped, cloth);
  const auto covered = hidden_dimensions(hidden, seen.observed, out.dimensions, garment.typical());
  for (const Dimension& d : garment.dimensions()) {
    const auto under = covered.find(d.name);
    const DimensionRole role = dimension_role(garment, out.dimensions, out.pattern, d.name);
    Measurement m = measurement_of(d, weigh(sources.at(d.name), role), stretch.at(d.name),
                                   solved.at(d.name).observable,
                                   under == covered.end() ? nullptr : &under->second, fixed);
    if (m.observable) m.sources = sources.at(d.name);
    out.measurements.push_back(std::move(m));
  }
  // From here on the pattern is the flat garment.
  for (const Measurement& m : out.measurements) out.dimensions[m.name] = m.flat;
  out.dimensions = nearest_holding(garment, out.dimensions, fixed);
  move_pattern(garment, out.dimensions, out.pattern);
  judge_drape(stage, seen.cloth, out);
  segment_by_cut(scan, stage.parts, GarmentRegion(seen.edges, stage.body), out.pattern, out.draped,
                 layer, cut_options(seen.edges), stage.labels);
  out.deviation = deviation_of(scan, out, stage.labels);
  take(stage, seen.cloth, find_caps(scan, seen.edges), out);
  stage.outer.push_back(outer_garment(out.pattern, out.draped));
  warn_about(garment, seen.edges, out, stage.warnings);
  return out;
}

}  // namespace regarment
