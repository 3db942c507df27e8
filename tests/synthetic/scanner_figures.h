#pragma once

#include <cmath>
#include <numbers>

#include "garment/find_template.h"
#include "support/tubes.h"
#include "synthetic/dressed_person.h"

namespace regarment::test {

/// A round column of `radius` and `height` metres on the floor, closed.
inline Mesh column(double radius, double height, double edge = 0.02) {
  Tube tube;
  tube.stations = {{0, radius, radius}, {height, radius, radius}};
  Mesh mesh;
  add_tube(tube, edge, {}, mesh);
  return mesh;
}

/// A ball with `rings` rings of triangles from pole to pole.
inline Mesh ball(const Vec3& centre, double radius, int rings = 60) {
  Mesh mesh;
  const int around = 2 * rings;
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double low = std::numbers::pi * i / rings, turn = std::numbers::pi * j / rings;
      mesh.positions.push_back(centre + radius * Vec3(std::sin(low) * std::sin(turn),
                                                      -std::cos(low),
                                                      std::sin(low) * std::cos(turn)));
    }
  const auto n = static_cast<std::uint32_t>(around);
  const auto last = static_cast<std::uint32_t>(rings - 2) * n;
  const auto south = static_cast<std::uint32_t>(mesh.positions.size()), north = south + 1;
  mesh.positions.push_back(centre - Vec3(0, radius, 0));
  mesh.positions.push_back(centre + Vec3(0, radius, 0));
  for (std::uint32_t j = 0; j < n; ++j) {
    const std::uint32_t k = (j + 1) % n;
    mesh.triangles.push_back({south, k, j});
    mesh.triangles.push_back({north, last + j, last + k});
    for (std::uint32_t low = 0; low < last; low += n) {
      mesh.triangles.push_back({low + j, low + k, low + n + k});
      mesh.triangles.push_back({low + j, low + n + k, low + n + j});
    }
  }
  return mesh;
}

/// A skirt that hangs as a straight cone about the upright line over the origin. m.
struct ConeSkirt {
  double waist = 0.80, width = 1.20, length = 0.50;
  double top = 1.0;  // height of the waist

  /// Radius of the middle of the cloth t metres down the panel.
  double radius(double t) const {
    return (waist + (width - waist) * t / length) / (2 * std::numbers::pi);
  }

  WornGarment worn(double edge_length, const SheetFabric& fabric, double band = 0) const {
    WornGarment garment;
    garment.template_name = "skirt";
    garment.dimensions = {{"waist", waist},
                          {"hip", waist + 0.2 * (width - waist) / length},
                          {"width", width},
                          {"length", length}};
    garment.fabric = fabric;
    garment.band = band;
    garment.pattern = make_pattern(find_template("skirt"), garment.dimensions, edge_length);
    const Pattern& pattern = garment.pattern;
    garment.particles.resize(static_cast<std::size_t>(pattern.particle_count));
    for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
      const bool front = pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[v])];
      const double s = pattern.flat[v].x(), t = pattern.flat[v].y(), r = radius(t);
      const double turn = s / r;
      garment.particles[static_cast<std::size_t>(pattern.particle[v])] = {
          r * std::sin(turn), top - t, (front ? r : -r) * std::cos(turn)};
    }
    return garment;
  }
};

}  // namespace regarment::test
