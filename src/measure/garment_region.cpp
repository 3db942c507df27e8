#include "measure/garment_region.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr double kOutside = -0.5;  // m, for points that are nowhere near the garment
constexpr double kUnder =
    0.07;  // m (deeper than folds) below the outer surface: a leg under a skirt
constexpr double kCoveredReach =
    0.06;  // m beyond where another garment hides an edge: its own hem waves

}  // namespace

double GarmentRegion::depth_on_torso(const Vec3& p) const {
  const LimbView& torso = edges_.limbs.at("torso");
  const LimbPoint at = torso.axis.locate(p);
  const int column = torso.map.column_of(at.phi);
  double depth = -kOutside;
  bool on_fold = false;
  for (const auto& [name, edge] : edges_.edges) {
    if (edge.limb == "torso") {
      const double beyond = edge.covered ? kCoveredReach : 0.0;
      const double fold = edge.folds.at(column, at.r);
      const double s = std::fmin(edge.found.s[column], fold);
      on_fold = on_fold || !std::isnan(fold);
      depth = std::min(depth, beyond + (edge.garment_above ? at.s - s : s - at.s));
    } else if (edge.limb == "neck") {
      const LimbView& neck = edges_.limbs.at("neck");
      const LimbPoint ray = neck.axis.locate(p);
      if (p.y() < neck.axis.point({0, 0, 0}).y()) continue;
      depth = std::min(depth, ray.s - edge.found.s[neck.map.column_of(ray.phi)]);
    }
  }
  if (depth <= 0 || on_fold) return depth;
  const double armpit = std::max(body_.armpit[0], body_.armpit[1]);
  if (armpit <= 0 || p.y() < armpit - 0.02) {
    const double outer = outer_radius(torso.map, at.s, at.phi);
    if (outer > 0 && at.r < outer - kUnder) return kOutside;
  }
  return depth;
}

bool GarmentRegion::on_fold(const Vec3& p) const {
  const LimbView& torso = edges_.limbs.at("torso");
  const LimbPoint at = torso.axis.locate(p);
  const int column = torso.map.column_of(at.phi);
  return std::any_of(edges_.edges.begin(), edges_.edges.end(), [&](const auto& edge) {
    return edge.second.limb == "torso" && !std::isnan(edge.second.folds.at(column, at.r));
  });
}

double GarmentRegion::depth_on_arm(const Vec3& p, int side) const {
  if (!edges_.upper_body) return kOutside;
  const char* limb = side == 0 ? "left_arm" : "right_arm";
  const auto view = edges_.limbs.find(limb);
  if (view == edges_.limbs.end()) return kOutside;
  const LimbPoint at = view->second.axis.locate(p);
  for (const auto& [name, edge] : edges_.edges)
    if (edge.limb == limb) return edge.found.s[view->second.map.column_of(at.phi)] - at.s;
  // This sleeve's edge is not seen: as far along the arm as the other one.
  for (const auto& [name, edge] : edges_.edges) {
    if (edge.limb != "left_arm" && edge.limb != "right_arm") continue;
    double mean = 0;
    for (double s : edge.found.s) mean += s / static_cast<double>(edge.found.s.size());
    return mean - at.s;
  }
  return kOutside;
}

double GarmentRegion::depth(const Vec3& p, BodyPart part) const {
  switch (part) {
    case BodyPart::LeftArm:
      return depth_on_arm(p, 0);
    case BodyPart::RightArm:
      return depth_on_arm(p, 1);
    case BodyPart::Trunk:
      return depth_on_torso(p);
    case BodyPart::Loose:
      return beside_torso(edges_.limbs.at("torso"), p) || on_fold(p) ? depth_on_torso(p) : kOutside;
  }
  return kOutside;
}

}  // namespace regarment
