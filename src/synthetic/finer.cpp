#include "synthetic/finer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace regarment {
namespace {

constexpr double kCell = 0.03;  // m

using Cell = std::array<int, 3>;  // panel, column, row

Cell cell_of(int panel, const Vec2& p) {
  return {panel, static_cast<int>(std::floor(p.x() / kCell)),
          static_cast<int>(std::floor(p.y() / kCell))};
}

/// Weights of a triangle's corners at a flat point.
Vec3 weights(const Pattern& pattern, const Triangle& t, const Vec2& p) {
  const Vec2 u = pattern.flat[t[1]] - pattern.flat[t[0]],
             v = pattern.flat[t[2]] - pattern.flat[t[0]];
  const Vec2 q = p - pattern.flat[t[0]];
  const double area = u.x() * v.y() - u.y() * v.x();
  const double b = (q.x() * v.y() - q.y() * v.x()) / area;
  const double c = (u.x() * q.y() - u.y() * q.x()) / area;
  return {1 - b - c, b, c};
}

/// Triangles by the cells their bounding boxes touch or lie beside.
std::map<Cell, std::vector<std::uint32_t>> index_of(const Pattern& pattern) {
  std::map<Cell, std::vector<std::uint32_t>> out;
  for (std::uint32_t i = 0; i < pattern.triangles.size(); ++i) {
    const Triangle& t = pattern.triangles[i];
    Vec2 low = pattern.flat[t[0]], high = low;
    for (const std::uint32_t v : t)
      low = low.cwiseMin(pattern.flat[v]), high = high.cwiseMax(pattern.flat[v]);
    const Cell from = cell_of(pattern.panel[t[0]], low - Vec2::Constant(kCell));
    const Cell to = cell_of(pattern.panel[t[0]], high + Vec2::Constant(kCell));
    for (int c = from[1]; c <= to[1]; ++c)
      for (int r = from[2]; r <= to[2]; ++r) out[{from[0], c, r}].push_back(i);
  }
  return out;
}

}  // namespace

std::vector<Vec3> onto_finer(const Pattern& coarse, const std::vector<Vec3>& x,
                             const Pattern& fine) {
  const auto index = index_of(coarse);
  const auto n = static_cast<std::size_t>(fine.particle_count);
  std::vector<Vec3> out(n, Vec3::Zero());
  std::vector<double> panels(n, 0.0);
  for (std::size_t v = 0; v < fine.flat.size(); ++v) {
    const auto near = index.find(cell_of(fine.panel[v], fine.flat[v]));
    if (near == index.end()) continue;
    double inside = -1e300;
    Vec3 place = Vec3::Zero();
    for (const std::uint32_t i : near->second) {
      const Triangle& t = coarse.triangles[i];
      const Vec3 w = weights(coarse, t, fine.flat[v]);
      if (w.minCoeff() <= inside) continue;
      inside = w.minCoeff();
      place.setZero();
      for (int k = 0; k < 3; ++k) place += w[k] * x[coarse.particle[t[k]]];
    }
    out[fine.particle[v]] += place;
    panels[fine.particle[v]] += 1;
  }
  for (std::size_t i = 0; i < n; ++i)
    if (panels[i] > 0) out[i] /= panels[i];
  return out;
}

}  // namespace regarment
