#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/mesh.h"

namespace regarment::test {

/// An ellipse across a tube's axis: where along it, how far off it, its half axes along u and v. m.
struct Station {
  double t = 0;
  double a = 0, b = 0;
  double off_u = 0, off_v = 0;
};

/// A body part of known shape: ellipses along a straight axis, joined by a smooth (C1) or a
/// straight blend of their sizes. Axis, u and v are a right-handed frame.
struct Tube {
  Vec3 origin = Vec3::Zero();
  Vec3 axis = Vec3::UnitY(), u = Vec3::UnitZ(), v = Vec3::UnitX();
  std::vector<Station> stations;  // ascending t
  bool straight = false;
  bool closed = true;  // a flat disc at both ends

  double low() const { return stations.front().t; }
  double high() const { return stations.back().t; }

  Station at(double t) const {
    std::size_t i = 0;
    while (i + 2 < stations.size() && t > stations[i + 1].t) ++i;
    const Station &p = stations[i], &q = stations[i + 1];
    double w = std::clamp((t - p.t) / (q.t - p.t), 0.0, 1.0);
    if (!straight) w = w * w * (3 - 2 * w);
    const auto blend = [&](double x, double y) { return (1 - w) * x + w * y; };
    return {t, blend(p.a, q.a), blend(p.b, q.b), blend(p.off_u, q.off_u), blend(p.off_v, q.off_v)};
  }

  Vec3 point(double t, double phi, double share = 1) const {
    const Station s = at(t);
    return origin + t * axis + (s.off_u + share * s.a * std::cos(phi)) * u +
           (s.off_v + share * s.b * std::sin(phi)) * v;
  }

  /// True for points deeper inside than `margin` metres, measured across the axis.
  bool holds(const Vec3& p, double margin = 0) const {
    const Vec3 d = p - origin;
    const double t = d.dot(axis);
    if (t < low() + margin || t > high() - margin) return false;
    const Station s = at(t);
    if (s.a <= margin || s.b <= margin) return false;
    const double x = (d.dot(u) - s.off_u) / (s.a - margin);
    const double y = (d.dot(v) - s.off_v) / (s.b - margin);
    return x * x + y * y < 1;
  }
};

/// Adds a tube's surface as triangles of about `edge` metres, counter-clockwise seen from outside;
/// triangles whose corners are all hidden inside one of `others` are left out.
inline void add_tube(const Tube& tube, double edge, const std::vector<Tube>& others, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  double widest = 0;
  for (const Station& s : tube.stations) widest = std::max({widest, s.a, s.b});
  const int around = std::max(16, static_cast<int>(2 * std::numbers::pi * widest / edge));
  const int along = std::max(2, static_cast<int>((tube.high() - tube.low()) / edge));
  const int discs = tube.closed ? std::max(2, static_cast<int>(widest / edge)) : 0;
  // Rings from the middle of the lower disc over the wall to the middle of the upper disc.
  const int rings = along + 1 + 2 * discs;
  for (int i = 0; i < rings; ++i) {
    const double t =
        tube.low() + (tube.high() - tube.low()) * std::clamp(i - discs, 0, along) / along;
    double share = 1;
    if (i < discs) share = (i + 0.02) / discs;
    if (i > discs + along) share = (rings - 1 - i + 0.02) / discs;
    for (int j = 0; j < around; ++j)
      mesh.positions.push_back(
          tube.point(t, 2 * std::numbers::pi * (j + 0.5 * (i % 2)) / around, share));
  }
  const auto hidden = [&](const Triangle& f) {
    return std::any_of(others.begin(), others.end(), [&](const Tube& o) {
      return std::all_of(f.begin(), f.end(),
                         [&](std::uint32_t k) { return o.holds(mesh.positions[k]); });
    });
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Triangle f{first + a, first + b, first + c};
    if (!hidden(f)) mesh.triangles.push_back(f);
  };
  const auto n = static_cast<std::uint32_t>(around);
  for (std::uint32_t i = 0; i + 1 < static_cast<std::uint32_t>(rings); ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      // Odd rings are turned by half a step, so that the triangles are near to equilateral.
      const std::uint32_t k = (j + 1) % n, here = i * n, next = here + n;
      if (i % 2 == 0) {
        add(here + j, here + k, next + j);
        add(here + k, next + k, next + j);
      } else {
        add(here + j, here + k, next + k);
        add(here + j, next + k, next + j);
      }
    }
}

/// Vertices that no triangle uses are taken out; `per_vertex` is kept in step.
template <class T>
void drop_unused(Mesh& mesh, std::vector<T>& per_vertex) {
  std::vector<std::uint32_t> to(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (std::uint32_t v : t) to[v] = 1;
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == 0) continue;
    mesh.positions[next] = mesh.positions[v];
    per_vertex[next] = per_vertex[v];
    to[v] = next++;
  }
  mesh.positions.resize(next);
  per_vertex.resize(next);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = to[v];
}

/// Vertex normals, each triangle weighted by its area.
inline void fill_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 n = (mesh.positions[t[1]] - mesh.positions[t[0]])
                       .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
    for (std::uint32_t v : t) mesh.normals[v] += n;
  }
  for (Vec3& n : mesh.normals) n = n.norm() > 0 ? Vec3(n.normalized()) : Vec3::Zero();
}

}  // namespace regarment::test
