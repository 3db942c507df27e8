#include "measure/section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLayer = 0.008;    // m below the outermost sample of a bin that still counts
constexpr double kNearest = 0.002;  // m from an edge: closer, a mesh rounds it off
constexpr double kFurthest = 0.012;

struct BinnedRadius {
  std::vector<std::vector<std::pair<double, double>>> values;  // (r, along) per bin

  explicit BinnedRadius(int bins) : values(static_cast<std::size_t>(bins)) {}
  void add(double angle, double r, double along) {
    const int n = static_cast<int>(values.size());
    const int bin = std::clamp(static_cast<int>((angle + kPi) / (2 * kPi) * n), 0, n - 1);
    values[bin].emplace_back(r, along);
  }
  /// Mean of the outermost layer of a bin: (r, along); NaN when the bin is empty.
  std::pair<double, double> outer(int bin) const {
    double most = -1;
    for (const auto& v : values[bin]) most = std::max(most, v.first);
    double r = 0, along = 0, n = 0;
    for (const auto& v : values[bin])
      if (v.first > most - kLayer) r += v.first, along += v.second, n += 1;
    if (n == 0) return {std::numeric_limits<double>::quiet_NaN(), 0};
    return {r / n, along / n};
  }
};

}  // namespace

Vec3 Section::point(int bin) const {
  const double angle = -kPi + (bin + 0.5) * 2 * kPi / static_cast<double>(r.size());
  return centre + r[bin] * (std::cos(angle) * zero + std::sin(angle) * quarter);
}

double Section::angle_of(const Vec3& p) const {
  return std::atan2((p - centre).dot(quarter), (p - centre).dot(zero));
}

double Section::length_between(const Vec3& from, const Vec3& to, const Vec3& via,
                               double min_share) const {
  const int n = static_cast<int>(r.size());
  const auto turn = [](double a) { return a < 0 ? a + 2 * kPi : a; };
  const double start = angle_of(from);
  const double forward = turn(angle_of(to) - start), middle = turn(angle_of(via) - start);
  const double sweep = middle <= forward ? forward : forward - 2 * kPi;
  const double step = 2 * kPi / n;
  const int count = static_cast<int>(std::abs(sweep) / step);
  std::vector<Vec3> points{from};
  int seen = 0;
  for (int k = 1; k < count; ++k) {
    const double angle = start + (sweep > 0 ? k : -k) * step;
    const double wrapped = std::remainder(angle, 2 * kPi);
    const int bin = std::clamp(static_cast<int>((wrapped + kPi) / step), 0, n - 1);
    if (std::isnan(r[bin])) continue;
    points.push_back(point(bin));
    ++seen;
  }
  points.push_back(to);
  if (count > 2 && seen < min_share * (count - 1)) return std::numeric_limits<double>::quiet_NaN();
  // Noise lengthens a curve: each inner point becomes the mean of its neighbourhood.
  std::vector<Vec3> smooth = points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const std::size_t half = std::min({std::size_t{2}, i, points.size() - 1 - i});
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = i - half; k <= i + half; ++k) sum += points[k];
    smooth[i] = sum / static_cast<double>(2 * half + 1);
  }
  double length = 0;
  for (std::size_t i = 1; i < smooth.size(); ++i) length += (smooth[i] - smooth[i - 1]).norm();
  return length;
}

Section cut_section(const SurfaceSamples& samples, const std::vector<int>& members,
                    const Vec3& centre, const Vec3& zero, const Vec3& quarter,
                    double half_thickness, int bins) {
  Section section{centre, zero, quarter, {}};
  const Vec3 normal = zero.cross(quarter);
  BinnedRadius binned(bins);
  for (int m : members) {
    const Vec3 d = samples.positions[m] - centre;
    if (std::abs(d.dot(normal)) > half_thickness) continue;
    const double a = d.dot(zero), b = d.dot(quarter);
    binned.add(std::atan2(b, a), std::hypot(a, b), 0);
  }
  for (int bin = 0; bin < bins; ++bin) section.r.push_back(binned.outer(bin).first);
  return section;
}

std::vector<Vec3> curve_beside_edge(const SurfaceSamples& samples, const std::vector<int>& members,
                                    const LimbAxis& axis, const LimbMap& map, const FoundEdge& edge,
                                    bool garment_above, int bins) {
  BinnedRadius binned(bins);
  for (int m : members) {
    const LimbPoint p = axis.locate(samples.positions[m]);
    const int column =
        std::min(static_cast<int>((p.phi + kPi) / (2 * kPi) * map.columns), map.columns - 1);
    const double inside = garment_above ? p.s - edge.s[column] : edge.s[column] - p.s;
    if (inside < kNearest || inside > kFurthest) continue;
    if (p.r > edge.r[column] + 0.08) continue;  // another limb behind this one
    binned.add(p.phi, p.r, p.s);
  }
  std::vector<Vec3> points;
  for (int bin = 0; bin < bins; ++bin) {
    const auto [r, s] = binned.outer(bin);
    if (std::isnan(r)) continue;
    points.push_back(axis.point({s, -kPi + (bin + 0.5) * 2 * kPi / bins, r}));
  }
  return points;
}

}  // namespace regarment
