#include "synthetic/surface_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "scan/mesh_normals.h"

namespace regarment {
namespace {

constexpr double kReach = 0.05;       // m, further away nothing is in contact
constexpr double kSoon = 0.002;       // m, nearer than this a particle may touch before long
constexpr double kAskAgain = 0.25;    // share of its distance a particle moves before it asks again
constexpr double kAlwaysGood = 5e-4;  // m it moves without asking, however near it is

/// Weights of the corners that make a point of the triangle's plane.
Vec3 weights_of(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double area = n.squaredNorm();
  if (!(area > 0)) return {1, 0, 0};
  const double v = n.dot((p - a).cross(c - a)) / area;
  const double w = n.dot((b - a).cross(p - a)) / area;
  return {1 - v - w, v, w};
}

Vec3 point_at(const std::vector<Vec3>& positions, const Triangle& t, const Vec3& weights) {
  return weights[0] * positions[t[0]] + weights[1] * positions[t[1]] + weights[2] * positions[t[2]];
}

}  // namespace

Obstacle::Obstacle(ObstacleKind kind, std::vector<Triangle> triangles, std::vector<Vec3> positions,
                   double thickness)
    : kind_(kind),
      triangles_(std::move(triangles)),
      now_(std::move(positions)),
      before_(now_),
      thickness_(thickness) {
  // Cloth around holds in what lies on its inner side.
  if (kind == ObstacleKind::Around)
    for (Triangle& t : triangles_) std::swap(t[0], t[1]);
  rebuild();
}

void Obstacle::move_to(std::vector<Vec3> positions) {
  before_ = std::move(now_);
  now_ = std::move(positions);
}

void Obstacle::rebuild() {
  normals_ = mesh_normals(now_, triangles_);
  tree_ = std::make_unique<ClosestPoint>(now_, triangles_);
}

ClosestHit Obstacle::closest(const Vec3& p, double reach) const {
  ClosestFilter filter;
  filter.max_distance = reach;
  return tree_->closest(p, filter);
}

Vec3 Obstacle::normal(std::uint32_t triangle, const Vec3& weights) const {
  return point_at(normals_, triangles_[triangle], weights).normalized();
}

Vec3 Obstacle::normal(const ClosestHit& hit) const {
  const Triangle& t = triangles_[hit.element];
  return normal(hit.element, weights_of(hit.point, now_[t[0]], now_[t[1]], now_[t[2]]));
}

SurfaceContact::SurfaceContact(const Sheet& sheet)
    : sheet_(sheet), contacts_(sheet.particle_count()) {}

SurfaceContact::Contact SurfaceContact::ask(const Obstacle& obstacle, std::size_t particle,
                                            const Vec3& p) const {
  Contact out;
  out.asked_at = p;
  if (obstacle.kind() == ObstacleKind::Around && sheet_.on_trunk[particle] == 0) {
    out.good_for = std::numeric_limits<double>::infinity();
    return out;
  }
  const ClosestHit hit = obstacle.closest(p, kReach);
  if (!hit.found()) {
    out.good_for = kAskAgain * kReach;
    return out;
  }
  out.good_for = std::max(kAlwaysGood, kAskAgain * std::sqrt(hit.squared_distance));
  // Beyond the edge of a garment there is nothing to touch.
  if (hit.on_border && obstacle.kind() != ObstacleKind::Body) return out;
  const Triangle& t = obstacle.triangles()[hit.element];
  const std::vector<Vec3>& at = obstacle.now();
  out.triangle = hit.element;
  out.weights = weights_of(hit.point, at[t[0]], at[t[1]], at[t[2]]);
  out.normal = obstacle.normal(hit.element, out.weights);
  return out;
}

void SurfaceContact::find(const Obstacle& obstacle, const std::vector<Vec3>& x, bool all) {
  for (std::size_t p = 0; p < x.size(); ++p) {
    const double moved = (x[p] - contacts_[p].asked_at).norm();
    if (!all && moved <= contacts_[p].good_for) continue;
    Contact fresh = ask(obstacle, p, x[p]);
    fresh.stuck_at = contacts_[p].stuck_at;
    fresh.sticks = contacts_[p].sticks;
    contacts_[p] = fresh;
  }
}

double SurfaceContact::depth(const Obstacle& obstacle, const Contact& c, const Vec3& x) const {
  const double touch = 0.5 * (sheet_.fabric.thickness + obstacle.thickness()) + kAirGap;
  const Vec3 on = point_at(obstacle.now(), obstacle.triangles()[c.triangle], c.weights);
  return touch - c.normal.dot(x - on);
}

void SurfaceContact::add_forces(const Obstacle& obstacle, const std::vector<Vec3>& x,
                                double pressure, std::vector<Vec3>& forces) const {
  for (std::size_t p = 0; p < x.size(); ++p) {
    const Contact& c = contacts_[p];
    if (c.triangle == ClosestHit::kNone) continue;
    const double deep = depth(obstacle, c, x[p]);
    if (deep <= 0) continue;
    const double k = pressure * sheet_.area[p];
    forces[p] += k * deep * c.normal;
    if (!c.sticks) continue;
    Vec3 rub = k * (c.stuck_at - x[p]);
    rub -= c.normal.dot(rub) * c.normal;
    const double most = sheet_.fabric.friction * k * deep, length = rub.norm();
    forces[p] += length > most ? Vec3(rub * (most / length)) : rub;
  }
}

void SurfaceContact::push_out(const Obstacle& obstacle, const std::vector<Vec3>& before,
                              std::vector<Vec3>& x) const {
  for (std::size_t p = 0; p < x.size(); ++p) {
    const Contact& c = contacts_[p];
    if (c.triangle == ClosestHit::kNone) continue;
    // Two garments give way alike.
    const double share = obstacle.kind() == ObstacleKind::Body ? 1.0 : 0.5;
    const double deep = share * depth(obstacle, c, x[p]);
    if (deep <= 0) continue;
    x[p] += deep * c.normal;
    const Triangle& t = obstacle.triangles()[c.triangle];
    Vec3 slide = x[p] - before[p] - point_at(obstacle.now(), t, c.weights) +
                 point_at(obstacle.before(), t, c.weights);
    slide -= c.normal.dot(slide) * c.normal;
    const double length = slide.norm(), held = sheet_.fabric.friction * deep;
    x[p] -= length > held ? Vec3(slide * (held / length)) : slide;
  }
}

void SurfaceContact::add_stiffness(const Obstacle& obstacle, const std::vector<Vec3>& x,
                                   double pressure, std::vector<double>& stiffness) const {
  for (std::size_t p = 0; p < x.size(); ++p) {
    const Contact& c = contacts_[p];
    if (c.triangle == ClosestHit::kNone || depth(obstacle, c, x[p]) < -kSoon) continue;
    stiffness[p] += pressure * sheet_.area[p];
  }
}

void SurfaceContact::settle(const Obstacle& obstacle, const std::vector<Vec3>& x) {
  for (std::size_t p = 0; p < x.size(); ++p) {
    Contact& c = contacts_[p];
    const double deep = c.triangle == ClosestHit::kNone ? 0.0 : depth(obstacle, c, x[p]);
    if (deep <= 0) {
      c.sticks = false;
      continue;
    }
    if (!c.sticks) c.stuck_at = x[p];
    c.sticks = true;
    Vec3 slid = x[p] - c.stuck_at;
    slid -= c.normal.dot(slid) * c.normal;
    const double most = sheet_.fabric.friction * deep, length = slid.norm();
    c.stuck_at = x[p] - (length > most ? Vec3(slid * (most / length)) : slid);
    const Triangle& t = obstacle.triangles()[c.triangle];
    c.stuck_at +=
        point_at(obstacle.now(), t, c.weights) - point_at(obstacle.before(), t, c.weights);
  }
}

}  // namespace regarment
