#pragma once

#include <cmath>
#include <numbers>

#include "drape/held_edge.h"
#include "garment/find_template.h"
#include "garment/pattern.h"
#include "geometry/mesh.h"

namespace regarment::test {

/// A skirt whose panels are trapezoids, worn without any stretch: each panel is bent onto half of
/// a cone whose apex is where its sides meet, or of a cylinder when they are parallel. Distances in
/// the panel are distances along the surface, so the flat dimensions are exactly those below. The
/// straight hem of a panel becomes a curve that rises to the middle. Body frame, m.
struct MadeSkirt {
  double waist = 0.80, width = 1.24, length = 0.55;
  double top = 1.0;  // height of the waist at the middle of a panel

  Dimensions dimensions() const {
    return {{"waist", waist},
            {"hip", waist + 0.2 * (width - waist) / length},
            {"width", width},
            {"length", length}};
  }

  /// Where the point (s, t) of the front or back panel lies, moved outwards by `off`.
  Vec3 worn(const Vec2& flat, bool front, double off = 0) const {
    const double facing = front ? 1 : -1;
    if (width == waist) {
      const double r = waist / (2 * std::numbers::pi), turn = flat.x() / r;
      return {(r + off) * std::sin(turn), top - flat.y(), facing * (r + off) * std::cos(turn)};
    }
    const double to_apex = waist * length / (width - waist);  // from the waist, in the panel
    const double sine = std::atan((width - waist) / (4 * length)) / (std::numbers::pi / 2);
    const double cosine = std::sqrt(1 - sine * sine);
    const double along = std::hypot(flat.x(), to_apex + flat.y());
    const double turn = std::atan2(flat.x(), to_apex + flat.y()) / sine;
    const double r = along * sine + off * cosine;
    return {r * std::sin(turn), top + (to_apex - along) * cosine + off * sine,
            facing * r * std::cos(turn)};
  }

  /// The point `share` of the way round, from the right side over the front, `t` below the waist.
  Vec3 round(double share, double t, double off = 0) const {
    const bool front = share < 0.5;
    const double quarter = (waist + (width - waist) * t / length) / 4;
    const double across = front ? 4 * share - 1 : 3 - 4 * share;
    return worn({across * quarter, t}, front, off);
  }

  /// A level line of the panels as a closed curve.
  std::vector<Vec3> curve(double t) const {
    std::vector<Vec3> out;
    constexpr int kPoints = 120;
    for (int i = 0; i < kPoints; ++i) out.push_back(round(static_cast<double>(i) / kPoints, t));
    return out;
  }

  /// Its surface, of `around` x `along` squares cut in two, counter-clockwise from outside.
  Mesh surface(int around = 120, int along = 60) const {
    Mesh mesh;
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i < around; ++i)
        mesh.positions.push_back(
            round(static_cast<double>(i) / around, length * static_cast<double>(j) / along));
    const auto at = [&](int i, int j) {
      return static_cast<std::uint32_t>(j * around + i % around);
    };
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < around; ++i) {
        mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
        mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
      }
    return mesh;
  }

  /// One position per vertex of a pattern of this skirt.
  std::vector<Vec3> wear(const Pattern& pattern, double off = 0) const {
    std::vector<Vec3> out;
    for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
      const auto panel = static_cast<std::size_t>(pattern.panel[v]);
      out.push_back(worn(pattern.flat[v], pattern.panel_is_front[panel], off));
    }
    return out;
  }
};

/// Particles of an edge of the pattern.
inline std::vector<int> edge_particles(const Pattern& pattern, const std::string& name) {
  std::vector<int> out;
  for (const int v : edge_named(pattern, name).vertices)
    out.push_back(pattern.particle[static_cast<std::size_t>(v)]);
  return out;
}

}  // namespace regarment::test
