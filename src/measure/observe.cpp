#include "measure/observe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/parallel.h"
#include "measure/observer.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOutlineReach = 0.006;  // m, see trace_outline
constexpr double kHalfSlice = 0.004;     // m, half the thickness of a slice that is outlined

}  // namespace

std::vector<int> Observer::on_cloth(const std::vector<int>& members) const {
  std::vector<int> kept;
  for (int m : members)
    if (cloth[m]) kept.push_back(m);
  return kept;
}

double Observer::half_slice() const { return std::max(kHalfSlice, 0.6 * samples.spacing); }
double Observer::reach() const { return std::max(kOutlineReach, 1.2 * samples.spacing); }

const GarmentEdge* Observer::edge(const std::string& name) const {
  const auto it = edges.edges.find(name);
  return it == edges.edges.end() ? nullptr : &it->second;
}

Vec3 Observer::edge_point(const GarmentEdge& e, double phi) const {
  const LimbView& view = limb(e);
  const int n = view.map.columns;
  const int j = ((static_cast<int>(std::floor((phi + kPi) / (2 * kPi) * n)) % n) + n) % n;
  return view.axis.point({e.found.s[j], view.map.column_phi(j), e.found.r[j]});
}

ObservedLength Observer::measure(const Observation& o) const {
  switch (o.kind) {
    case Observation::Kind::Girth:
      return girth(o);
    case Observation::Kind::GirthAtOffset:
      return girth_at_offset(o);
    case Observation::Kind::Path:
      return path(o);
    case Observation::Kind::Fork:
      return fork(o);
  }
  return {&o, 0, 0, false};
}

ObservedLength Observer::girth(const Observation& o) const {
  const GarmentEdge* e = edge(o.edge);
  if (!e || e->covered || e->found.coverage < 0.5) return {&o, 0, 0, false};
  return e->limb == "torso" ? torso_girth(o, *e) : cuff_girth(o, *e);
}

ObservedLength Observer::girth_at_offset(const Observation& o) const {
  const GarmentEdge* e = edge(o.edge);
  if (!e || e->limb != "torso") return {&o, 0, 0, false};
  if (o.side == "underarm") return chest_girth(o, *e);
  return e->covered ? ObservedLength{&o, 0, 0, false} : level_girth(o, *e);
}

std::vector<ObservedLength> observe(const SurfaceSamples& samples, const Body& body,
                                    const GarmentEdges& edges,
                                    const std::vector<std::uint8_t>& cloth,
                                    const GarmentTemplate& garment) {
  Observer observer{samples, body, edges, cloth, garment};
  observer.trunk = observer.trunk_levels();
  const auto& asked = garment.observations();
  std::vector<ObservedLength> out(asked.size());
  parallel_for(asked.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out[i] = observer.measure(asked[i]);
  });
  return out;
}

}  // namespace regarment
