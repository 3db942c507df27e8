#include "measure/observe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  std::vector<ObservedLength> out;
  for (const Observation& o : garment.observations()) {
    switch (o.kind) {
      case Observation::Kind::Girth:
        out.push_back(observer.girth(o));
        break;
      case Observation::Kind::GirthAtOffset:
        out.push_back(observer.girth_at_offset(o));
        break;
      case Observation::Kind::Path:
        out.push_back(observer.path(o));
        break;
      case Observation::Kind::Fork:
        out.push_back(observer.fork(o));
        break;
    }
  }
  return out;
}

}  // namespace regarment
