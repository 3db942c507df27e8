#include "measure/tucked_cuff.h"

#include <algorithm>

namespace regarment {
namespace {

// By made people: beyond either of these the whole edge shows.
constexpr double kNearArmpit = 0.09;    // m along the arm
constexpr double kBelowArmpit = 0.015;  // m
constexpr double kLowered = 0.42;       // downwards part of the arm's direction, 65 degrees

}  // namespace

bool is_tucked(const GarmentEdge& cuff, const GarmentEdges& edges, const Body& body) {
  if (cuff.covered || !cuff.found.found()) return false;
  if (cuff.limb != "left_arm" && cuff.limb != "right_arm") return false;
  const double armpit = body.armpit[cuff.limb == "left_arm" ? 0 : 1];
  if (!(armpit > 0)) return false;
  const LimbView& arm = edges.limbs.at(cuff.limb);
  const double at = cuff.found.mean_s();
  if (at > kNearArmpit || arm.axis.tangent(at).y() > -kLowered) return false;
  const std::vector<Vec3> points = edge_points(cuff.found, arm.map, arm.axis);
  const auto lowest = std::min_element(points.begin(), points.end(),
                                       [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  return lowest->y() > armpit - kBelowArmpit;
}

double tucked_share(const GarmentEdges& edges, const Body& body) {
  double tucked = 0, cuffs = 0;
  for (const auto& [name, edge] : edges.edges) {
    if (edge.limb != "left_arm" && edge.limb != "right_arm") continue;
    cuffs += 1;
    if (is_tucked(edge, edges, body)) tucked += 1;
  }
  return cuffs > 0 ? tucked / cuffs : 0;
}

}  // namespace regarment
