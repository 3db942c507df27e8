#include "analysis/hidden_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace regarment {
namespace {

// Top edges of 124 made skirts, as shares of the person's height: mean and deviation.
constexpr double kTopEdge = 0.60, kTopEdgeSpread = 0.028;
constexpr double kLeastHidden = 0.02;  // m, less would show where the outer hem waves
// m: a shirt that is tucked in comes out again when it is shorter, and is in the way when longer.
constexpr double kTucked = 0.12, kTuckedSpread = 0.05;
// Of the girth below it, how far a top edge is from what is typical: a deviation that both size
// charts and made skirts stay within.
constexpr double kTopShareSpread = 0.08;
constexpr double kLeastRun = 0.05;  // m, cloth over which a taper is told

/// Mean and deviation of a normal variable that is known to be larger than `least`.
HiddenEdge at_least(double mean, double deviation, double least) {
  const double z = (least - mean) / deviation;
  const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  const double ratio = density / std::max(1e-6, 0.5 * std::erfc(z / std::numbers::sqrt2));
  const double share = std::max(0.01, 1 + z * ratio - ratio * ratio);
  return {std::max(least, mean + deviation * ratio), deviation * std::sqrt(share)};
}

/// The dimension that an observation of this kind at this edge gives; 0 when it is none.
double given_by(const std::vector<ObservedLength>& observed, Observation::Kind kind,
                const std::string& edge, const Dimensions& dimensions) {
  for (const ObservedLength& o : observed) {
    if (o.observation->kind != kind || o.observation->edge != edge) continue;
    if (!o.observation->side.empty()) continue;
    const auto found = dimensions.find(o.observation->equals);
    if (found != dimensions.end()) return found->second;
  }
  return 0;
}

/// How much a girth at an offset from a hidden edge changes per m that the edge lies elsewhere: by
/// the taper of the cloth from there to the garment's other end.
double taper(const Observation& hoop, double girth, const std::vector<ObservedLength>& observed,
             const Dimensions& dimensions) {
  for (const ObservedLength& o : observed) {
    if (o.observation->kind != Observation::Kind::Path || o.observation->edge != hoop.edge)
      continue;
    const auto length = dimensions.find(o.observation->equals);
    const double end =
        given_by(observed, Observation::Kind::Girth, o.observation->to_edge, dimensions);
    if (length == dimensions.end() || end <= 0) continue;
    return std::abs(end - girth) / std::max(kLeastRun, length->second - hoop.offset);
  }
  return 1;
}

}  // namespace

std::map<std::string, HiddenEdge> hidden_edges(const GarmentEdges& edges, const Body& body) {
  std::map<std::string, HiddenEdge> out;
  for (const auto& [name, edge] : edges.edges) {
    if (!edge.covered || edge.limb != "torso") continue;
    const double cut = edge.found.mean_s();
    out[name] = edge.garment_above ? at_least(kTucked, kTuckedSpread, kLeastHidden)
                                   : at_least(kTopEdge * body.height - cut,
                                              kTopEdgeSpread * body.height, kLeastHidden);
  }
  return out;
}

std::optional<ProbableLength> probable_length(const ObservedLength& path,
                                              const std::map<std::string, HiddenEdge>& hidden) {
  if (path.seen || path.value <= 0 || path.observation->kind != Observation::Kind::Path) return {};
  ProbableLength out{path.value, 0};
  for (const std::string& end : {path.observation->edge, path.observation->to_edge}) {
    const auto edge = hidden.find(end);
    if (edge == hidden.end()) continue;
    out.value += edge->second.beyond;
    out.standard_deviation = std::hypot(out.standard_deviation, edge->second.standard_deviation);
  }
  if (out.standard_deviation <= 0) return {};
  return out;
}

std::map<std::string, HiddenDimension> hidden_dimensions(
    const std::map<std::string, HiddenEdge>& hidden, const std::vector<ObservedLength>& observed,
    const Dimensions& dimensions, const Dimensions& typical) {
  std::map<std::string, HiddenDimension> out;
  for (const ObservedLength& o : observed) {
    const auto dimension = dimensions.find(o.observation->equals);
    if (dimension == dimensions.end()) continue;
    for (const std::string& end : {o.observation->edge, o.observation->to_edge}) {
      const auto edge = hidden.find(end);
      if (edge == hidden.end() || o.seen) continue;
      HiddenDimension& d = out[dimension->first];
      d.least = std::max(d.least, o.value);
      switch (o.observation->kind) {
        case Observation::Kind::Path:
          if (const auto length = probable_length(o, hidden))
            d.value = length->value, d.standard_deviation = length->standard_deviation;
          break;
        case Observation::Kind::GirthAtOffset:
          if (!o.observation->side.empty()) break;
          d.told = o.observation->offset > edge->second.beyond;
          d.standard_deviation = edge->second.standard_deviation *
                                 taper(*o.observation, dimension->second, observed, dimensions);
          break;
        case Observation::Kind::Girth: {
          const auto hoop = Observation::Kind::GirthAtOffset;
          const double found = given_by(observed, hoop, end, dimensions);
          const double usual = given_by(observed, hoop, end, typical);
          if (found <= 0 || usual <= 0) break;
          d.value = typical.at(dimension->first) / usual * found;
          d.standard_deviation = kTopShareSpread * found;
          break;
        }
        case Observation::Kind::Fork:
          break;
      }
    }
  }
  return out;
}

}  // namespace regarment
