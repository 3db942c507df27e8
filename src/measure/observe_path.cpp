#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/observer.h"
#include "measure/section.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPathShare = 0.01, kLeastDeviation = 0.004;  // of a way, and m

}  // namespace

/// Way over the surface in the half plane of the trunk's axis at angle `phi` between two edges.
double Observer::centre_path(const GarmentEdge& from, const GarmentEdge& to, double phi) const {
  const Vec3 a = edge_point(from, phi), b = edge_point(to, phi);
  const LimbView& view = edges.limbs.at("torso");
  const double middle = 0.5 * (a.y() + b.y());
  const Vec3 centre = view.axis.point({middle, 0, 0});
  const Vec3 out = std::cos(phi) * Vec3::UnitZ() + std::sin(phi) * Vec3::UnitX();
  const Section section =
      cut_section(samples, on_cloth(view.members), centre, Vec3::UnitY(), out, 0.008, 240);
  return section.length_between(a, b, centre + 0.2 * out);
}

UpperEdge Observer::upper_edge(const GarmentEdge& from, const GarmentEdge& to) const {
  const Vec3 neck = edge_point(from, to.limb == "left_arm" ? 0.5 * kPi : -0.5 * kPi);
  const Vec3 cuff = edge_point(to, 0.0);
  const Vec3 along = (cuff - neck).normalized();
  const Vec3 up = (Vec3::UnitY() - Vec3::UnitY().dot(along) * along).normalized();
  std::vector<int> members = edges.limbs.at("torso").members;
  const std::vector<int>& arm = edges.limbs.at(to.limb).members;
  members.insert(members.end(), arm.begin(), arm.end());
  const Vec3 centre = 0.5 * (neck + cuff) - 0.15 * up;
  return {neck, cuff, cut_section(samples, on_cloth(members), centre, up, along, 0.01, 240)};
}

ObservedLength Observer::path(const Observation& o) const {
  ObservedLength out{&o, 0, 0, false};
  const GarmentEdge *from = edge(o.edge), *to = edge(o.to_edge);
  if (!from || !to) return out;
  std::vector<double> ways;
  if (o.side == "centre") {
    ways = {centre_path(*from, *to, 0.0), centre_path(*from, *to, kPi)};
  } else if (o.side == "shoulder_point") {
    const LimbView& torso = edges.limbs.at("torso");
    for (const double side : {0.5 * kPi, -0.5 * kPi}) {
      const Vec3 shoulder = edge_point(*from, side);
      const double low = *std::min_element(to->found.s.begin(), to->found.s.end());
      const Vec3 centre(shoulder.x(), 0.5 * (shoulder.y() + low),
                        torso.axis.point({0.5 * (shoulder.y() + low), 0, 0}).z());
      const Section section = cut_section(samples, on_cloth(torso.members), centre, Vec3::UnitY(),
                                          Vec3::UnitZ(), 0.008, 240);
      for (const double z : {1.0, -1.0}) {
        // The hem where this plane meets it, in front and behind.
        double best = 1e9;
        Vec3 hem = centre;
        for (int j = 0; j < torso.map.columns; ++j) {
          const Vec3 p =
              torso.axis.point({to->found.s[j], torso.map.column_phi(j), to->found.r[j]});
          if (z * (p.z() - centre.z()) < 0 || std::abs(p.x() - centre.x()) >= best) continue;
          best = std::abs(p.x() - centre.x());
          hem = p;
        }
        if (best > 0.02) continue;
        ways.push_back(section.length_between(shoulder, hem, centre + 0.3 * z * Vec3::UnitZ()));
      }
    }
  } else if (o.side == "top") {
    const UpperEdge upper = upper_edge(*from, *to);
    ways = {upper.section.length_between(upper.neck, upper.cuff,
                                         upper.section.centre + 0.3 * upper.section.zero)};
  }
  double sum = 0, n = 0;
  for (double w : ways)
    if (std::isfinite(w)) sum += w, n += 1;
  if (n == 0) return out;
  out.value = sum / n;
  out.standard_deviation = kPathShare * out.value + kLeastDeviation +
                           std::hypot(from->found.standard_error, to->found.standard_error);
  if (o.side != "centre")
    out.standard_deviation +=
        o.side == "top" ? 0.008 : 0.004;  // where neck and shoulder meet is hard to see
  out.seen = !from->covered && !to->covered;
  return out;
}

}  // namespace regarment
