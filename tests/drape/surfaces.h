#pragma once

#include <cmath>
#include <numbers>

#include "geometry/closest_point.h"
#include "geometry/mesh.h"
#include "support/tubes.h"

namespace regarment::test {

inline ClosestPoint closest_on(const Mesh& mesh) {
  return {std::span(mesh.positions), std::span(mesh.triangles)};
}

/// A square of `side` metres at the height `y`, of two triangles, facing up or down.
inline void add_sheet(double side, double y, bool up, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const double h = side / 2;
  for (const Vec2& p : {Vec2(-h, -h), Vec2(-h, h), Vec2(h, h), Vec2(h, -h)})
    mesh.positions.emplace_back(p.x(), y, p.y());
  for (Triangle t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}}) {
    if (!up) std::swap(t[1], t[2]);
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

inline Mesh sheet(double y = 0, double side = 4) {
  Mesh mesh;
  add_sheet(side, y, true, mesh);
  return mesh;
}

/// A ball about the origin, of rings that are `edge` metres apart.
inline Mesh ball(double radius, double edge) {
  Mesh mesh;
  const int rings = static_cast<int>(std::ceil(std::numbers::pi * radius / edge));
  const auto around = static_cast<std::uint32_t>(2 * rings);
  for (int i = 1; i < rings; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / around;
      mesh.positions.push_back(
          radius * Vec3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)));
    }
  const auto top = static_cast<std::uint32_t>(mesh.positions.size()), bottom = top + 1;
  mesh.positions.emplace_back(0, radius, 0);
  mesh.positions.emplace_back(0, -radius, 0);
  for (std::uint32_t j = 0; j < around; ++j) {
    const std::uint32_t k = (j + 1) % around, last = (rings - 2) * around;
    mesh.triangles.push_back({top, k, j});
    mesh.triangles.push_back({bottom, last + j, last + k});
    for (std::uint32_t i = 0; i < last; i += around) {
      mesh.triangles.push_back({i + j, i + k, i + around + k});
      mesh.triangles.push_back({i + j, i + around + k, i + around + j});
    }
  }
  return mesh;
}

/// An upright cylinder about the y axis, open at both ends.
inline Mesh pillar(double radius, double low, double high, double edge) {
  Tube tube;
  tube.stations = {{low, radius, radius}, {high, radius, radius}};
  tube.closed = false;
  Mesh mesh;
  add_tube(tube, edge, {}, mesh);
  return mesh;
}

}  // namespace regarment::test
