#include "synthetic/sheet.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kSmallestArea = 1e-10;  // m^2

SheetElement make_element(const Pattern& pattern, std::size_t index, double band) {
  const Triangle& t = pattern.triangles[index];
  Eigen::Matrix2d sides;
  sides << pattern.flat[t[1]] - pattern.flat[t[0]], pattern.flat[t[2]] - pattern.flat[t[0]];
  SheetElement out;
  out.area = std::abs(sides.determinant()) / 2;
  if (!(out.area > kSmallestArea)) {
    throw InvalidInput("make_sheet: triangle " + std::to_string(index) +
                       " of the pattern has no area");
  }
  const Eigen::Matrix2d inverse = sides.inverse();
  out.across = inverse.col(0);
  out.along = inverse.col(1);
  double depth = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    out.corner[k] = static_cast<std::uint32_t>(pattern.particle[t[k]]);
    depth += pattern.flat[t[k]].y() / 3;
  }
  out.layers = band > 0 && depth < band ? 2.0 : 1.0;
  return out;
}

/// Cotangent of the angle at corner `k` of a flat triangle.
double cotangent(const Pattern& pattern, const Triangle& t, std::size_t k) {
  const Vec2 a = pattern.flat[t[(k + 1) % 3]] - pattern.flat[t[k]];
  const Vec2 b = pattern.flat[t[(k + 2) % 3]] - pattern.flat[t[k]];
  return a.dot(b) / std::abs(a.x() * b.y() - a.y() * b.x());
}

/// One side of an edge between two triangles.
struct Wing {
  std::uint32_t opposite = 0;            // particle
  double cot_low = 0.0, cot_high = 0.0;  // at the edge's particle of lower, higher number
  double area = 0.0, layers = 1.0;
};

using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;

std::map<EdgeKey, std::vector<Wing>> find_wings(const Pattern& pattern,
                                                const std::vector<SheetElement>& elements) {
  std::map<EdgeKey, std::vector<Wing>> wings;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const SheetElement& e = elements[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      Wing wing{e.corner[m], cotangent(pattern, pattern.triangles[i], k),
                cotangent(pattern, pattern.triangles[i], l), e.area, e.layers};
      EdgeKey key{e.corner[k], e.corner[l]};
      if (key.first > key.second) {
        std::swap(key.first, key.second);
        std::swap(wing.cot_low, wing.cot_high);
      }
      wings[key].push_back(wing);
    }
  }
  return wings;
}

BendingMatrix make_bending(const std::map<EdgeKey, std::vector<Wing>>& wings, std::size_t n,
                           double stiffness) {
  std::vector<std::map<std::uint32_t, double>> rows(n);
  for (const auto& [edge, sides] : wings) {
    if (sides.size() != 2) continue;
    const Wing &a = sides[0], &b = sides[1];
    const std::array<std::uint32_t, 4> at = {edge.first, edge.second, a.opposite, b.opposite};
    const std::array<double, 4> k = {a.cot_high + b.cot_high, a.cot_low + b.cot_low,
                                     -a.cot_low - a.cot_high, -b.cot_low - b.cot_high};
    // Two sheets sewn flat on each other bend as one of twice the thickness.
    const double layers = std::min(a.layers, b.layers);
    // Scaled so that an even mesh rolled on a cylinder has the energy of a plate, whichever way.
    const double factor = stiffness * layers * layers * layers / (a.area + b.area);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) rows[at[i]][at[j]] += factor * k[i] * k[j];
  }
  BendingMatrix out;
  out.begin.push_back(0);
  for (const auto& row : rows) {
    for (const auto& [column, value] : row) {
      out.column.push_back(column);
      out.value.push_back(value);
    }
    out.begin.push_back(static_cast<std::uint32_t>(out.column.size()));
  }
  return out;
}

std::vector<std::vector<std::uint32_t>> two_rings(const std::map<EdgeKey, std::vector<Wing>>& wings,
                                                  std::size_t n) {
  std::vector<std::vector<std::uint32_t>> ring(n), out(n);
  for (const auto& [edge, sides] : wings) {
    ring[edge.first].push_back(edge.second);
    ring[edge.second].push_back(edge.first);
  }
  for (std::size_t p = 0; p < n; ++p) {
    out[p] = ring[p];
    out[p].push_back(static_cast<std::uint32_t>(p));
    for (const std::uint32_t q : ring[p])
      out[p].insert(out[p].end(), ring[q].begin(), ring[q].end());
    std::sort(out[p].begin(), out[p].end());
    out[p].erase(std::unique(out[p].begin(), out[p].end()), out[p].end());
  }
  return out;
}

}  // namespace

Sheet make_sheet(const Pattern& pattern, const SheetFabric& fabric, double band) {
  fabric.check();
  Sheet sheet;
  sheet.fabric = fabric;
  const auto n = static_cast<std::size_t>(pattern.particle_count);
  sheet.area.assign(n, 0.0);
  sheet.mass.assign(n, 0.0);
  sheet.elements.reserve(pattern.triangles.size());
  for (std::size_t i = 0; i < pattern.triangles.size(); ++i) {
    sheet.elements.push_back(make_element(pattern, i, band));
    const SheetElement& e = sheet.elements.back();
    for (const std::uint32_t p : e.corner) {
      sheet.area[p] += e.area / 3;
      sheet.mass[p] += e.area * e.layers * fabric.density / 3;
    }
  }
  const auto wings = find_wings(pattern, sheet.elements);
  double sum = 0;
  for (const SheetElement& e : sheet.elements) sum += e.area;
  sheet.edge_length =
      std::sqrt(sum / static_cast<double>(sheet.elements.size()) * 4 / std::sqrt(3.0));
  sheet.bending = make_bending(wings, n, fabric.bending);
  sheet.bending_diagonal.assign(n, 0.0);
  for (std::uint32_t p = 0; p < n; ++p)
    for (std::uint32_t k = sheet.bending.begin[p]; k < sheet.bending.begin[p + 1]; ++k)
      if (sheet.bending.column[k] == p) sheet.bending_diagonal[p] = sheet.bending.value[k];
  sheet.on_trunk.assign(n, 0);
  for (std::size_t v = 0; v < pattern.particle.size(); ++v)
    if (pattern.panel_limbs.empty() || pattern.panel_limbs[pattern.panel[v]] == "torso")
      sheet.on_trunk[pattern.particle[v]] = 1;
  sheet.near = two_rings(wings, n);
  for (const SheetElement& e : sheet.elements) sheet.triangles.push_back(e.corner);
  return sheet;
}

}  // namespace regarment
