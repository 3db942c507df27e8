#include "analysis/weigh_estimates.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

struct Weights {
  double fit, line, scan;  // how much each source counts
  double least;            // m, deviation where all agree
  double share;            // of the value, the same
  double apart;            // of how far the sources lie apart
};

Weights weights_of(DimensionRole role) {
  switch (role) {
    case DimensionRole::BearingEdge:
      return {0.2, 0.4, 0.4, 0.004, 0, 0.5};
    case DimensionRole::TorsoEdge:
      return {0.4, 0.3, 0.3, 0.004, 0, 0.5};
    case DimensionRole::LimbEdge:
      return {0.4, 0.3, 0.3, 0.004, 0, 0.5};
    case DimensionRole::Hoop:
      return {0.4, 0.3, 0.3, 0.004, 0, 0.5};
    case DimensionRole::Seam:
      return {0.4, 0.3, 0.3, 0.004, 0, 0.5};
    case DimensionRole::Length:
      return {0.4, 0.3, 0.3, 0.004, 0, 0.5};
    case DimensionRole::WaistLength:
      return {0.4, 0.3, 0.3, 0.004, 0, 0.5};
    case DimensionRole::LimbLength:
      break;
  }
  return {0.4, 0.3, 0.3, 0.004, 0, 0.5};
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
      if (o.seen && o.observation->equals == d.name) sources.scan = o.value;
  }
  return out;
}

WornEstimate weigh(const WornSources& sources, DimensionRole role) {
  const Weights w = weights_of(role);
  double sum = w.fit * sources.fit + w.line * sources.line, all = w.fit + w.line;
  double low = std::min(sources.fit, sources.line), high = std::max(sources.fit, sources.line);
  if (sources.scan) {
    sum += w.scan * *sources.scan, all += w.scan;
    low = std::min(low, *sources.scan), high = std::max(high, *sources.scan);
  }
  const double value = sum / all;
  return {value, std::hypot(w.least + w.share * value, w.apart * (high - low))};
}

}  // namespace regarment
