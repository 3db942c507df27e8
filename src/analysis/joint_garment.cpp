#include <algorithm>
#include <cmath>

#include "analysis/asymmetry.h"
#include "analysis/joint_start.h"
#include "analysis/mixture.h"
#include "analysis/weigh_estimates.h"
#include "base/error.h"
#include "fabric/free_girth.h"
#include "fabric/worn_stretch.h"
#include "garment/hold_dimensions.h"
#include "geometry/parallel.h"
#include "measure/garment_region.h"
#include "measure/tucked_cuff.h"
#include "segmentation/caps.h"
#include "segmentation/segment_by_cut.h"

namespace regarment {
namespace {

// Of the cloth seen that lies on the fitted garment. Of 186 fits to what made people wear one has
// less than 0.8, none less than 0.7. Fits of what they do not wear have as much: this tells a fit
// that failed; the wrong garment shows in its edges.
constexpr double kLeastMatched = 0.5, kWellMatched = 0.8;
// m: what the labels make of an edge's standard error, which is that of its mean, not of each
// place.
constexpr double kLeastBorderError = 0.003, kMostBorderError = 0.02;

std::string share_text(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// A worn dimension if edges lie elsewhere.
struct OtherLength {
  std::vector<std::string> edges;  // that moved
  double weight = 0;
  double longer = 0;  // m, than between the edges as found
};

/// m, standard deviation of the flat length.
double flat_deviation(const WornEstimate& worn, const Stretch& stretch) {
  return std::hypot(worn.standard_deviation, worn.value * stretch.standard_deviation);
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
  double deviation = flat_deviation(worn, stretch);
  if (!seen && hidden) deviation = std::hypot(deviation, hidden->standard_deviation);
  m.low = std::max(d.lower, m.flat - kNormal90 * deviation);
  m.high = std::min(d.upper, m.flat + kNormal90 * deviation + worn.above);
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

/// How much longer a worn dimension would be if edges lay where each of the other starts has them.
/// All starts are compared at the coarse level.
std::vector<OtherLength> others_of(const GarmentTemplate& garment,
                                   const std::vector<JointStart>& starts, const std::string& name,
                                   DimensionRole role) {
  const auto worn = [&](const JointStart& start) {
    return weigh(worn_sources(garment, start.coarse, start.seen.observed).at(name), role).value;
  };
  std::vector<OtherLength> out;
  for (std::size_t i = 1; i < starts.size(); ++i)
    out.push_back({starts[i].moved, starts[i].weight, worn(starts[i]) - worn(starts[0])});
  return out;
}

/// Says what a measurement would be if edges lay elsewhere, and widens its interval to hold that.
void add_others(const Dimension& d, const WornEstimate& worn, const Stretch& stretch,
                const std::vector<OtherLength>& others, Measurement& m) {
  if (others.empty()) return;
  const double deviation = flat_deviation(worn, stretch);
  double own = 1;
  std::vector<Outcome> outcomes;
  for (const OtherLength& other : others) {
    const double flat = std::clamp(m.flat + other.longer / (1 + stretch.mean), d.lower, d.upper);
    m.rivals.push_back({other.edges, flat, other.weight});
    outcomes.push_back({other.weight, flat, deviation});
    own -= other.weight;
  }
  outcomes.push_back({own, m.flat, deviation});
  m.low = std::clamp(mixture_quantile(outcomes, 0.05), d.lower, m.low);
  m.high = std::clamp(mixture_quantile(outcomes, 0.95), m.high, d.upper);
}

CutOptions cut_options(const GarmentEdges& edges) {
  CutOptions options;
  for (const auto& [name, edge] : edges.edges)
    options.edge_error[name] =
        std::clamp(edge.found.standard_error, kLeastBorderError, kMostBorderError);
  return options;
}

/// What follows from a fit and is not part of the result by itself.
struct FollowUp {
  std::map<std::string, Stretch> stretch;  // by dimension
  std::vector<std::uint8_t> caps;
};

/// In ways that do not need each other: the placement, the labels and what hangs on them, how the
/// sides differ, how far the cloth is stretched, and the caps.
FollowUp follow_up(const Scan& scan, const GarmentTemplate& garment,
                   const std::vector<JointStart>& starts, const JointFit& fit, Stage& stage,
                   GarmentAnalysis& out) {
  const SeenGarment& seen = starts.front().seen;
  FollowUp follow;
  StretchOptions cloth;
  cloth.fabric = stage.options.fabric;
  const auto label = [&] {
    segment_by_cut(scan, stage.parts, GarmentRegion(seen.edges, stage.body), fit.pattern,
                   fit.draped, out.layer, cut_options(seen.edges), stage.labels);
    out.deviation = deviation_of(scan, out, stage.labels);
  };
  run_together(
      {[&] {
         follow.stretch = worn_stretch(garment, fit.dimensions, fit.pattern, fit.draped, cloth);
       },
       label, [&] { out.asymmetry = find_asymmetry(garment, starts, fit, stage); },
       [&] { out.placed = place_garment(fit.pattern, placement_target(seen.edges, fit.pattern)); },
       [&] { follow.caps = find_caps(scan, seen.edges); }});
  return follow;
}

}  // namespace

GarmentAnalysis joint_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                              Stage& stage, const Progress& progress) {
  const std::vector<JointStart> starts = joint_starts(garment, layer, stage, progress);
  const JointStart& best = starts.front();
  const SeenGarment& seen = best.seen;
  const JointFit fit = finish_joint_fit(garment, best, stage, progress);
  if (fit.matched < kLeastMatched)
    throw NoGarmentError(
        "no " + garment.name() + " on this scan: only " + share_text(fit.matched) +
        " of what lies between its edges fits one; ask for the garment that is worn");
  check_stays_up(garment, fit.dimensions, seen.edges, stage);
  if (fit.matched < kWellMatched)
    stage.warnings.push_back(garment.title() + ": only " + share_text(fit.matched) +
                             " of the cloth seen lies on the fitted garment; it may be a different "
                             "garment");
  GarmentAnalysis out;
  out.template_name = garment.name();
  out.layer = layer;
  out.edges = edge_curves(seen.edges);
  out.dimensions = fit.dimensions;
  out.pattern = fit.pattern;
  out.draped = fit.draped;
  const FollowUp follow = follow_up(scan, garment, starts, fit, stage, out);
  const Dimensions& fixed = fixed_of(stage.options, garment);
  const auto sources = worn_sources(garment, fit, seen.observed);
  const auto free = free_girths(garment, out.dimensions, out.pattern, out.draped);
  const auto covered =
      hidden_dimensions(best.hidden, seen.observed, out.dimensions, garment.typical());
  const double tucked = tucked_share(seen.edges, stage.body);
  for (const Dimension& d : garment.dimensions()) {
    const auto under = covered.find(d.name);
    const DimensionRole role = dimension_role(garment, out.dimensions, out.pattern, d.name);
    WornEstimate worn = weigh(sources.at(d.name), role, tucked);
    Stretch stretched = follow.stretch.at(d.name);
    if (const auto hanging = free.find(d.name); hanging != free.end()) {
      worn = weigh_free(worn, hanging->second);
      stretched = where_free(stretched, hanging->second);
    }
    const bool is_seen = best.solved.at(d.name).observable;
    Measurement m = measurement_of(d, worn, stretched, is_seen,
                                   under == covered.end() ? nullptr : &under->second, fixed);
    if (is_seen && !m.fixed)
      add_others(d, worn, stretched, others_of(garment, starts, d.name, role), m);
    if (m.observable) m.sources = sources.at(d.name);
    out.measurements.push_back(std::move(m));
  }
  for (const SideDifference& d : out.asymmetry)
    stage.warnings.push_back(asymmetry_in_words(garment, d));
  // From here on the pattern is the flat garment.
  for (const Measurement& m : out.measurements) out.dimensions[m.name] = m.flat;
  out.dimensions = nearest_holding(garment, out.dimensions, fixed);
  move_pattern(garment, out.dimensions, out.pattern);
  judge_drape(stage, seen.cloth, out);
  take(stage, seen.cloth, follow.caps, out);
  stage.outer.push_back(outer_garment(out.pattern, out.draped));
  warn_about(garment, seen.edges, out, stage.warnings);
  return out;
}

}  // namespace regarment
