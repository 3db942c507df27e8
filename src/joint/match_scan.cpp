#include "joint/match_scan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "garment/particles.h"
#include "garment/worn_normals.h"
#include "geometry/closed_curve.h"
#include "geometry/closest_point.h"
#include "geometry/parallel.h"
#include "joint/worn_lines.h"

namespace regarment {
namespace {

constexpr double kLeastEdgeError = 0.002;  // m

Vec3 shares_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 u = b - a, v = c - a, w = p - a;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), wu = w.dot(u), wv = w.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-24)) return Vec3::Constant(1.0 / 3);
  const double s = (vv * wu - uv * wv) / determinant, t = (uu * wv - uv * wu) / determinant;
  return {1 - s - t, s, t};
}

void match_surface(const JointTarget& target, const std::vector<Triangle>& triangles,
                   const std::vector<Vec3>& x, const MatchOptions& options, JointModel& model) {
  const ClosestPoint garment(x, triangles);
  const JointScales& scales = model.scales();
  std::vector<ClosestHit> hits(target.points.size());
  parallel_for(hits.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t q = begin; q < end; ++q)
      hits[q] =
          garment.closest(target.points[q], {options.reach, target.normals[q], options.min_cosine});
  });
  for (std::size_t q = 0; q < hits.size(); ++q) {
    const ClosestHit& hit = hits[q];
    if (!hit.found()) continue;
    Vec3 beyond = target.points[q] - hit.point;
    beyond -= beyond.dot(target.normals[q]) * target.normals[q];
    const double way = beyond.norm();
    if (hit.on_border && way > options.uncovered) continue;
    SurfaceMatch match;
    for (int c = 0; c < 3; ++c) match.particles[c] = static_cast<int>(triangles[hit.element][c]);
    match.share =
        shares_of(x[match.particles[0]], x[match.particles[1]], x[match.particles[2]], hit.point);
    match.point = target.points[q];
    match.normal = target.normals[q];
    // Behind the cloth there may be skin; what lies in front of it is cloth.
    const bool behind = (target.points[q] - hit.point).dot(hit.normal) < 0;
    const double robust = behind ? options.robust : options.robust_outside;
    const double ratio = hit.squared_distance / (robust * robust);
    match.weight = target.areas[q] / scales.patch / (scales.surface * scales.surface) /
                   ((1 + ratio) * (1 + ratio));
    model.surface.push_back(match);
    // Scan beyond a fold's ridge lies on no cloth yet: the cloth is drawn towards it.
    const Vec3 off = target.points[q] - hit.point;
    const double past_ridge = (off - off.dot(hit.normal) * hit.normal).norm();
    if (hit.on_border || std::min(way, past_ridge) < options.uncovered) continue;
    match.normal = beyond / way;
    match.weight *= options.ridge_share;
    model.surface.push_back(match);
  }
}

void match_edges(const JointTarget& target, const std::vector<Vec3>& normals,
                 const std::vector<Vec3>& x, JointModel& model) {
  for (const PatternEdge& edge : model.pattern().edges) {
    const auto seen = target.edges.find(edge.name);
    if (seen == target.edges.end() || seen->second.curve.size() < 3) continue;
    const double error = std::max(kLeastEdgeError, seen->second.standard_error);
    const double parts = seen->second.as_one ? 1.0 : model.scales().edge_parts;
    const double weight = parts / (error * error) / static_cast<double>(edge.vertices.size());
    for (const int v : edge.vertices) {
      const int p = model.pattern().particle[v];
      const CurvePoint at = closest_on_curve(seen->second.curve, x[p]);
      const Vec3 across = at.along.cross(normals[p]);
      if (!(across.norm() > 1e-12)) continue;
      model.edges.push_back({p, at.point, across.normalized(), weight});
    }
  }
}

}  // namespace

std::vector<double> coverage(const JointModel& model) {
  std::vector<double> seen(model.pattern().particle_count, 0.0);
  const double full = 1 / model.scales().patch / (model.scales().surface * model.scales().surface);
  for (const SurfaceMatch& m : model.surface)
    for (int c = 0; c < 3; ++c) seen[m.particles[c]] += m.share[c] * m.weight / full;
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i] = std::min(1.0, 1.5 * seen[i] / model.particle_areas()[i]);
  return seen;
}

void match_scan(const JointTarget& target, const std::vector<Vec3>& x, const MatchOptions& options,
                JointModel& model) {
  model.surface.clear(), model.edges.clear();
  const std::vector<Triangle> triangles = particle_triangles(model.pattern());
  match_surface(target, triangles, x, options, model);
  const std::vector<Vec3> normals = worn_normals(model.pattern(), x);
  match_edges(target, normals, x, model);
  model.arcs.clear(), model.slack.clear();
  const std::vector<double> covered = coverage(model);
  for (const Spring& s : model.springs()) {
    const Vec3 chord = x[s.particle_b] - x[s.particle_a];
    const double arc = arc_over_chord(chord, normals[s.particle_a], normals[s.particle_b]);
    const double strain = chord.norm() * arc / s.rest_length - 1;
    model.arcs.push_back(arc);
    const double support = std::min(covered[s.particle_a], covered[s.particle_b]);
    model.slack.push_back(strain < 0 ? std::max(options.unseen, support) : 1.0);
  }
}

}  // namespace regarment
