#include "synthetic/self_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr double kMargin = 0.005;      // m beyond the contact distance that pairs are looked for
constexpr double kShareOfEdge = 0.25;  // thinner cloth would slip between its own particles
constexpr double kOutside = 0.15;      // of a corner's weight, beyond a triangle's side
constexpr double kSlowSlide = 2e-4;    // m a step, below which friction holds like a spring
constexpr std::size_t kMostCells = 4'000'000;

}  // namespace

SelfContact::SelfContact(const Sheet& sheet)
    : sheet_(sheet),
      distance_(std::max(sheet.fabric.thickness, kShareOfEdge * sheet.edge_length)) {}

std::array<int, 3> SelfContact::Grid::cell_of(const Vec3& p) const {
  std::array<int, 3> out{};
  for (int k = 0; k < 3; ++k)
    out[k] = std::clamp(static_cast<int>((p[k] - low[k]) / cell), 0, size[k] - 1);
  return out;
}

void SelfContact::sort_particles(const std::vector<Vec3>& x) {
  Vec3 high = x[0];
  grid_.low = x[0];
  for (const Vec3& p : x) grid_.low = grid_.low.cwiseMin(p), high = high.cwiseMax(p);
  grid_.cell = std::max(1.2 * sheet_.edge_length, 0.004);
  std::size_t cells = 1;
  do {
    cells = 1;
    for (int k = 0; k < 3; ++k) {
      grid_.size[k] = 1 + static_cast<int>((high[k] - grid_.low[k]) / grid_.cell);
      cells *= static_cast<std::size_t>(grid_.size[k]);
    }
    if (cells > kMostCells) grid_.cell *= 1.5;
  } while (cells > kMostCells);
  grid_.begin.assign(cells + 1, 0);
  std::vector<std::uint32_t> at(x.size());
  for (std::size_t p = 0; p < x.size(); ++p) {
    const auto c = grid_.cell_of(x[p]);
    at[p] = static_cast<std::uint32_t>(grid_.index(c[0], c[1], c[2]));
    ++grid_.begin[at[p] + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) grid_.begin[c + 1] += grid_.begin[c];
  grid_.particle.resize(x.size());
  std::vector<std::uint32_t> next(grid_.begin.begin(), grid_.begin.end() - 1);
  for (std::size_t p = 0; p < x.size(); ++p)
    grid_.particle[next[at[p]]++] = static_cast<std::uint32_t>(p);
}

void SelfContact::pair_up(std::uint32_t triangle, const std::vector<Vec3>& x) {
  const Triangle& t = sheet_.triangles[triangle];
  const Vec3 &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
  const Vec3 n = (b - a).cross(c - a);
  const double area = n.norm();
  if (!(area > 0)) return;
  const Vec3 unit = n / area;
  const double reach = distance_ + kMargin;
  const Vec3 pad = Vec3::Constant(reach);
  const auto low = grid_.cell_of(a.cwiseMin(b).cwiseMin(c) - pad);
  const auto high = grid_.cell_of(a.cwiseMax(b).cwiseMax(c) + pad);
  for (int i = low[0]; i <= high[0]; ++i)
    for (int j = low[1]; j <= high[1]; ++j) {
      const std::uint32_t first = grid_.begin[grid_.index(i, j, low[2])];
      const std::uint32_t last = grid_.begin[grid_.index(i, j, high[2]) + 1];
      for (std::uint32_t k = first; k < last; ++k) {
        const std::uint32_t p = grid_.particle[k];
        const Vec3 from = x[p] - a;
        const double height = unit.dot(from);
        if (std::abs(height) > reach) continue;
        const double v = n.dot(from.cross(c - a)) / (area * area);
        const double w = n.dot((b - a).cross(from)) / (area * area);
        if (v < -kOutside || w < -kOutside || v + w > 1 + kOutside) continue;
        const auto& near = sheet_.near[p];
        const bool joined = std::any_of(t.begin(), t.end(), [&](std::uint32_t q) {
          return std::binary_search(near.begin(), near.end(), q);
        });
        if (joined) continue;
        pairs_.push_back({p, triangle, {1 - v - w, v, w}, height < 0 ? -1.0 : 1.0});
      }
    }
}

void SelfContact::find(const std::vector<Vec3>& x) {
  pairs_.clear();
  if (x.empty()) return;
  sort_particles(x);
  for (std::uint32_t t = 0; t < sheet_.triangles.size(); ++t) pair_up(t, x);
}

SelfContact::Overlap SelfContact::overlap(const Pair& pair, const std::vector<Vec3>& before,
                                          const std::vector<Vec3>& x) const {
  const Triangle& t = sheet_.triangles[pair.triangle];
  const Vec3 &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
  const auto& w = pair.weights;
  Overlap out;
  out.normal = pair.side * (b - a).cross(c - a).normalized();
  out.depth = distance_ - out.normal.dot(x[pair.particle] - (w[0] * a + w[1] * b + w[2] * c));
  // Deeper than cloth can get between two searches: the triangle has turned over.
  if (out.depth > 2 * distance_) out.depth = 0;
  if (out.depth <= 0) return out;
  const Vec3 moved = x[pair.particle] - before[pair.particle] - w[0] * (a - before[t[0]]) -
                     w[1] * (b - before[t[1]]) - w[2] * (c - before[t[2]]);
  out.slide = moved - out.normal.dot(moved) * out.normal;
  return out;
}

void SelfContact::add_forces(const std::vector<Vec3>& before, const std::vector<Vec3>& x,
                             double pressure, std::vector<Vec3>& forces) const {
  for (const Pair& pair : pairs_) {
    const Overlap o = overlap(pair, before, x);
    if (o.depth <= 0) continue;
    const double push = pressure * sheet_.area[pair.particle] * o.depth;
    const double rub = sheet_.fabric.friction * push / (o.slide.norm() + kSlowSlide);
    const Vec3 force = push * o.normal - rub * o.slide;
    forces[pair.particle] += force;
    const Triangle& t = sheet_.triangles[pair.triangle];
    for (int k = 0; k < 3; ++k) forces[t[k]] -= pair.weights[k] * force;
  }
}

void SelfContact::separate(const std::vector<Vec3>& before, std::vector<Vec3>& x) const {
  for (const Pair& pair : pairs_) {
    const Overlap o = overlap(pair, before, x);
    if (o.depth <= 0) continue;
    const Triangle& t = sheet_.triangles[pair.triangle];
    const double own = 1 / sheet_.mass[pair.particle];
    double all = own;
    for (int k = 0; k < 3; ++k) all += pair.weights[k] * pair.weights[k] / sheet_.mass[t[k]];
    const double length = o.slide.norm(), held = sheet_.fabric.friction * o.depth;
    const Vec3 back = length > held ? Vec3(o.slide * (held / length)) : o.slide;
    const Vec3 push = (o.depth * o.normal - back) / all;
    x[pair.particle] += own * push;
    for (int k = 0; k < 3; ++k) x[t[k]] -= pair.weights[k] / sheet_.mass[t[k]] * push;
  }
}

void SelfContact::add_stiffness(double pressure, std::vector<double>& stiffness) const {
  for (const Pair& pair : pairs_) {
    const double k = 2 * pressure * sheet_.area[pair.particle];
    stiffness[pair.particle] += k;
    const Triangle& t = sheet_.triangles[pair.triangle];
    for (int i = 0; i < 3; ++i) stiffness[t[i]] += k * std::abs(pair.weights[i]);
  }
}

}  // namespace regarment
