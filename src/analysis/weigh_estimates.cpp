#include "analysis/weigh_estimates.h"

#include <algorithm>
#include <cmath>

#include "analysis/mixture.h"

namespace regarment {
namespace {

// Of a hem's girth: how far a fit may lie off the edge seen, how much the edge counts, and half
// widths of 90 % intervals, of the girth and of the distance between both.
constexpr double kHangingReach = 0.1, kHangingScan = 0.5;
constexpr double kHangingShare = 0.07, kHangingApart = 0.3;

// In centimetres: half widths of 90 % intervals, as tests/benchmarks/joint_calibration.py prints
// them for 200 made people.
struct Weights {
  double fit, line, scan;  // how much each source counts
  double least;            // cm, where all agree
  double apart;            // of how far the sources lie apart
  double over = 1.0;       // how much too long all sources are
};

// Half widths of 90 % intervals of a girth where it hangs free: m, and of how far it lies from what
// is seen under the arms.
constexpr double kFreeLeast = 0.011, kFreeApart = 0.4;
// How much it counts where it is shorter than what is seen under the arms: holes and folds that
// nothing shows make a girth too short, hardly anything makes it too long.
constexpr double kFreeShorter = 0.5;

// m, of the edges of sleeves that end in an armpit: what lies hidden there, the half width of the
// interval at least, and how much further up it reaches.
constexpr double kTuckedLength = 0.05, kTuckedDoubt = 0.08, kTuckedAbove = 0.025;

Weights weights_of(DimensionRole role) {
  switch (role) {
    case DimensionRole::BearingEdge:
      return {0.4, 0.4, 0.2, 1.6, 0.8};
    case DimensionRole::TorsoEdge:
      return {0.8, 0.1, 0.1, 0.6, 2.0};
    case DimensionRole::LimbEdge:
      return {0.8, 0.1, 0.1, 1.3, 2.2};
    case DimensionRole::Hoop:
      return {0.35, 0.5, 0.15, 1.1, 1.0};
    case DimensionRole::Seam:
      return {0.4, 0.5, 0.1, 5.0, 0.8, 1.03};
    case DimensionRole::Length:
      return {0.1, 0.1, 0.8, 0.45, 0.7};
    case DimensionRole::WaistLength:
      return {0.1, 0.1, 0.8, 0.5, 0.8};
    case DimensionRole::LimbLength:
      break;
  }
  return {0.7, 0.3, 0.0, 2.0, 2.5};
}

/// A hem with folds that hang: the fit may crumple cloth in them, and runs along the edge seen miss
/// cloth where it turns.
WornEstimate weigh_hanging(const WornSources& sources) {
  const double scan = *sources.scan, most = kHangingReach * scan;
  const double fit = std::clamp(sources.fit, scan - most, scan + most);
  const double value = (1 - kHangingScan) * fit + kHangingScan * scan;
  return {value, (kHangingShare * value + kHangingApart * std::abs(fit - scan)) / kNormal90};
}

}  // namespace

std::map<std::string, WornSources> worn_sources(const GarmentTemplate& garment, const JointFit& fit,
                                                const std::vector<ObservedLength>& observed) {
  std::map<std::string, WornSources> out;
  for (const Dimension& d : garment.dimensions()) {
    WornSources& sources = out[d.name];
    sources.fit = fit.dimensions.at(d.name);
    const auto line = fit.worn.find(d.name);
    sources.line = line == fit.worn.end() ? sources.fit : line->second;
    for (const ObservedLength& o : observed)
      if (o.seen && o.observation->equals == d.name)
        sources.scan = o.value, sources.hanging = o.hanging;
  }
  return out;
}

WornEstimate weigh(const WornSources& sources, DimensionRole role, double tucked) {
  if (sources.hanging && sources.scan) return weigh_hanging(sources);
  const Weights w = weights_of(role);
  double sum = w.fit * sources.fit + w.line * sources.line, all = w.fit + w.line;
  double low = std::min(sources.fit, sources.line), high = std::max(sources.fit, sources.line);
  if (sources.scan) {
    sum += w.scan * *sources.scan, all += w.scan;
    low = std::min(low, *sources.scan), high = std::max(high, *sources.scan);
  }
  const double value = sum / all / w.over;
  const double doubt = 0.01 * w.least + w.apart * (high - low);
  if (role != DimensionRole::LimbEdge || !(tucked > 0)) return {value, doubt / kNormal90};
  return {value + tucked * kTuckedLength, std::max(doubt, tucked * kTuckedDoubt) / kNormal90,
          tucked * kTuckedAbove};
}

WornEstimate weigh_free(const WornEstimate& here, const FreeGirth& free) {
  const double longer = free.length - here.value;
  const double weight = longer < 0 ? kFreeShorter * free.loose : free.loose;
  const double doubt = kFreeLeast + kFreeApart * std::abs(longer);
  WornEstimate out = here;
  out.value += weight * longer;
  out.standard_deviation += weight * (doubt / kNormal90 - here.standard_deviation);
  return out;
}

}  // namespace regarment
