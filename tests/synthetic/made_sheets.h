#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// A flat panel of columns x rows squares of side `h` m, cut along alternating diagonals; particle
/// i + (columns + 1) j at s = i h, t = j h.
inline Pattern grid_pattern(int columns, int rows, double h) {
  Pattern p;
  p.panel_names = {"sheet"};
  p.panel_limbs = {"torso"};
  p.panel_is_front = {true};
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i + (columns + 1) * j); };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      p.particle.push_back(static_cast<int>(at(i, j)));
      p.panel.push_back(0);
      p.flat.emplace_back(i * h, j * h);
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
      if ((i + j) % 2 == 0) {
        p.triangles.push_back({a, c, d});
        p.triangles.push_back({a, d, b});
      } else {
        p.triangles.push_back({a, c, b});
        p.triangles.push_back({b, c, d});
      }
    }
  p.particle_count = static_cast<int>(p.flat.size());
  return p;
}

/// A flat panel of equilateral triangles of side `h` m, `columns` in a row, every other row set off
/// by half a side and half a triangle shorter at one end; particle i + (columns + 1) j.
inline Pattern lattice_pattern(int columns, int rows, double h) {
  Pattern p = grid_pattern(columns, rows, h);
  p.triangles.clear();
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i + (columns + 1) * j); };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      p.flat[at(i, j)] = {(i + 0.5 * (j % 2)) * h, j * h * std::sqrt(0.75)};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
      if (j % 2 == 0) {
        p.triangles.push_back({a, c, b});
        p.triangles.push_back({b, c, d});
      } else {
        p.triangles.push_back({a, c, d});
        p.triangles.push_back({a, d, b});
      }
    }
  return p;
}

/// One position per vertex from its flat place; particles and vertices agree.
inline std::vector<Vec3> placed(const Pattern& pattern,
                                const std::function<Vec3(const Vec2&)>& where) {
  std::vector<Vec3> out(static_cast<std::size_t>(pattern.particle_count));
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    out[pattern.particle[v]] = where(pattern.flat[v]);
  return out;
}

/// A large square of two triangles through `on`, facing `normal`.
struct MadePlane {
  std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  std::vector<Vec3> corners;

  MadePlane(const Vec3& on, const Vec3& normal) {
    const Vec3 u = normal.unitOrthogonal() * 5, v = normal.cross(u);
    corners = {on - u - v, on + u - v, on + u + v, on - u + v};
  }
};

}  // namespace regarment
