#include "fabric/dimension_role.h"

#include <algorithm>

namespace regarment {
namespace {

// Mean t of an edge of the flat pattern, m: small is high.
double depth(const Pattern& pattern, const PatternEdge& edge) {
  double sum = 0;
  for (const int v : edge.vertices) sum += pattern.flat[static_cast<std::size_t>(v)].y();
  return sum / static_cast<double>(edge.vertices.size());
}

// The highest edge round the trunk of a garment without a neckline.
bool bears(const Pattern& pattern, const PatternEdge& edge) {
  return std::all_of(pattern.edges.begin(), pattern.edges.end(), [&](const PatternEdge& other) {
    return &other == &edge ||
           (other.limb == "torso" && depth(pattern, other) > depth(pattern, edge));
  });
}

DimensionRole edge_role(const Pattern& pattern, const std::string& name) {
  const PatternEdge& edge = edge_named(pattern, name);
  if (edge.limb != "torso") return DimensionRole::LimbEdge;
  return bears(pattern, edge) ? DimensionRole::BearingEdge : DimensionRole::TorsoEdge;
}

DimensionRole role_seen(const Pattern& pattern, const Observation& observation) {
  switch (observation.kind) {
    case Observation::Kind::Girth:
      return edge_role(pattern, observation.edge);
    case Observation::Kind::GirthAtOffset:
      return DimensionRole::Hoop;
    case Observation::Kind::Fork:
      return DimensionRole::Seam;
    case Observation::Kind::Path:
      break;
  }
  const PatternEdge& from = edge_named(pattern, observation.edge);
  if (edge_named(pattern, observation.to_edge).limb != "torso") return DimensionRole::LimbLength;
  const bool from_waist = from.limb == "torso" && bears(pattern, from);
  return from_waist ? DimensionRole::WaistLength : DimensionRole::Length;
}

}  // namespace

DimensionRole dimension_role(const GarmentTemplate& garment, const Dimensions& dimensions,
                             const Pattern& pattern, const std::string& name) {
  const bool round = garment.dimension(name).circumference;
  bool found = false;
  DimensionRole out = round ? DimensionRole::Hoop : DimensionRole::Length;
  for (const Observation& observation : garment.observations()) {
    if (!garment.gives(observation.equals, name, dimensions)) continue;
    const DimensionRole role = role_seen(pattern, observation);
    if (!found || role == DimensionRole::Hoop) out = role;
    found = true;
  }
  return out;
}

}  // namespace regarment
