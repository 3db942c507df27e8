#include "placement/limb_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/median.h"

namespace regarment {
namespace {

constexpr double kPolarRadius = 0.15;  // m that stand for one radian from straight up
constexpr double kBelowNeck =
    0.16;  // m from the narrowest level of the neck down to the rays' centre
constexpr double kLayer =
    0.006;  // m: samples this far below the outermost one still count as outer

Vec3 perpendicular(const Vec3& v, const Vec3& axis) {
  const Vec3 p = v - v.dot(axis) * axis;
  return p.norm() > 1e-6 ? Vec3(p.normalized()) : Vec3(axis.unitOrthogonal());
}

}  // namespace

LimbAxis::LimbAxis(std::vector<Vec3> points, std::vector<double> s, const Vec3& reference)
    : points_(std::move(points)), s_(std::move(s)) {
  if (points_.size() < 2 || s_.size() != points_.size())
    throw InvalidInput("LimbAxis: needs at least two points with a parameter each");
  const std::size_t n = points_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 along = points_[std::min(i + 1, n - 1)] - points_[i == 0 ? 0 : i - 1];
    tangent_.push_back(along.normalized());
    zero_.push_back(perpendicular(reference, tangent_[i]));
    quarter_.push_back(tangent_[i].cross(zero_[i]));
  }
}

std::size_t LimbAxis::segment(double s) const {
  const auto it = std::upper_bound(s_.begin(), s_.end(), s);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, it - s_.begin() - 1));
  return std::min(i, s_.size() - 2);
}

LimbAxis LimbAxis::polar(const Vec3& centre) {
  LimbAxis axis;
  axis.polar_ = true;
  axis.points_ = {centre};
  axis.s_ = {0.0, std::numbers::pi * kPolarRadius};
  return axis;
}

LimbPoint LimbAxis::locate(const Vec3& p) const {
  if (polar_) {
    const Vec3 d = p - points_[0];
    const double r = d.norm();
    if (r < 1e-9) return {};
    return {kPolarRadius * std::acos(std::clamp(d.y() / r, -1.0, 1.0)), std::atan2(d.x(), d.z()),
            r};
  }
  std::size_t best = 0;
  double best_t = 0, best_distance = std::numeric_limits<double>::infinity();
  if (vertical_) {
    best = segment(p.y());
    best_t = (p.y() - s_[best]) / (s_[best + 1] - s_[best]);
  } else {
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Vec3 d = points_[i + 1] - points_[i];
      double t = (p - points_[i]).dot(d) / d.squaredNorm();
      // The end segments go on beyond the axis.
      if (i > 0) t = std::max(t, 0.0);
      if (i + 2 < points_.size()) t = std::min(t, 1.0);
      const double distance = (points_[i] + t * d - p).squaredNorm();
      if (distance < best_distance) best_distance = distance, best = i, best_t = t;
    }
  }
  const Vec3 foot = points_[best] + best_t * (points_[best + 1] - points_[best]);
  const double w = std::clamp(best_t, 0.0, 1.0);
  const Vec3 zero = (1 - w) * zero_[best] + w * zero_[best + 1];
  const Vec3 quarter = (1 - w) * quarter_[best] + w * quarter_[best + 1];
  const double a = (p - foot).dot(quarter), b = (p - foot).dot(zero);
  return {s_[best] + best_t * (s_[best + 1] - s_[best]), std::atan2(a, b), std::hypot(a, b)};
}

Vec3 LimbAxis::radial(double s, double phi) const {
  if (polar_) {
    const double theta = s / kPolarRadius;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
  }
  const std::size_t i = segment(s);
  const double w = std::clamp((s - s_[i]) / (s_[i + 1] - s_[i]), 0.0, 1.0);
  const Vec3 zero = (1 - w) * zero_[i] + w * zero_[i + 1];
  const Vec3 quarter = (1 - w) * quarter_[i] + w * quarter_[i + 1];
  return (std::cos(phi) * zero + std::sin(phi) * quarter).normalized();
}

Vec3 LimbAxis::tangent(double s) const {
  if (polar_) return Vec3::UnitY();
  const std::size_t i = segment(s);
  const double w = std::clamp((s - s_[i]) / (s_[i + 1] - s_[i]), 0.0, 1.0);
  return ((1 - w) * tangent_[i] + w * tangent_[i + 1]).normalized();
}

Vec3 LimbAxis::point(const LimbPoint& p) const {
  if (polar_) return points_[0] + p.r * radial(p.s, p.phi);
  const std::size_t i = segment(p.s);
  const double t = (p.s - s_[i]) / (s_[i + 1] - s_[i]);
  return points_[i] + t * (points_[i + 1] - points_[i]) + p.r * radial(p.s, p.phi);
}

LimbAxis trunk_axis(const Body& body) {
  std::vector<double> y, x, z;
  for (const TrunkLevel& level : body.trunk) {
    if (!level.present) continue;
    y.push_back(level.y);
    x.push_back(level.centre().x());
    z.push_back(level.centre().y());
  }
  // The middle of a slice jumps where a hem or a hand begins; the axis is its running median over
  // 16 cm, then smoothed over the same.
  const auto smoothed = [&](std::vector<double> v) {
    const int n = static_cast<int>(v.size()), half = 8;
    std::vector<double> middle(v.size()), mean(v.size());
    for (int i = 0; i < n; ++i) {
      middle[i] =
          median({v.begin() + std::max(0, i - half), v.begin() + std::min(n, i + half + 1)});
    }
    for (int i = 0; i < n; ++i) {
      double sum = 0, weight = 0;
      for (int k = std::max(0, i - half); k < std::min(n, i + half + 1); ++k)
        sum += middle[k], weight += 1;
      mean[i] = sum / weight;
    }
    return mean;
  };
  x = smoothed(x), z = smoothed(z);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < y.size(); ++i) points.emplace_back(x[i], y[i], z[i]);
  LimbAxis axis(std::move(points), std::move(y), Vec3::UnitZ());
  // Heights are the trunk's parameter: sections are horizontal whatever the lean of the axis.
  axis.vertical_ = true;
  for (std::size_t i = 0; i < axis.points_.size(); ++i) {
    axis.tangent_[i] = Vec3::UnitY();
    axis.zero_[i] = Vec3::UnitZ();
    axis.quarter_[i] = Vec3::UnitX();
  }
  return axis;
}

LimbAxis arm_axis(const Body& body, int side) {
  const std::vector<Vec3>& points = body.arms[side].points;
  std::vector<double> s{-body.arm_axis_lead};
  for (std::size_t i = 1; i < points.size(); ++i)
    s.push_back(s.back() + std::max(1e-6, (points[i] - points[i - 1]).norm()));
  return LimbAxis(points, std::move(s), Vec3::UnitY());
}

LimbAxis neck_axis(const Body& body) {
  const double y = body.neck - kBelowNeck;
  const Vec2 middle = body.level(y).centre();
  return LimbAxis::polar({body.level(body.neck).centre().x(), y, middle.y()});
}

double LimbMap::column_phi(double j) const {
  return -std::numbers::pi + (j + 0.5) * 2 * std::numbers::pi / columns;
}

int LimbMap::column_of(double phi) const {
  const double turn = std::remainder(phi, 2 * std::numbers::pi);
  return std::clamp(static_cast<int>((turn + std::numbers::pi) / (2 * std::numbers::pi) * columns),
                    0, columns - 1);
}

double outer_radius(const LimbMap& map, double s, double phi, double reach) {
  const double turn = phi / (2 * std::numbers::pi) + 0.5;
  const int j = std::clamp(static_cast<int>(turn * map.columns), 0, map.columns - 1);
  const int row = static_cast<int>(std::floor((s - map.s_low) / map.step));
  const auto near_row = [&](int column) {
    for (const int d : {0, 1, -1, 2, -2}) {
      const int i = row + d;
      if (i >= 0 && i < map.rows && map.has(i, column)) return map.radius[map.index(i, column)];
    }
    return -1.0;
  };
  const double here = near_row(j);
  const int most = static_cast<int>(reach / (2 * std::numbers::pi) * map.columns);
  if (here >= 0 || most < 1) return here;
  double back = -1, ahead = -1;
  int b = 0, a = 0;
  while (back < 0 && b < most) back = near_row(j - ++b);
  while (ahead < 0 && a < most) ahead = near_row(j + ++a);
  if (back < 0 || ahead < 0) return -1;
  return (back * a + ahead * b) / (a + b);
}

LimbMap make_limb_map(const SurfaceSamples& samples, const std::vector<int>& members,
                      const LimbAxis& axis, double s_low, double s_high, double step, int columns,
                      double min_facing) {
  LimbMap map;
  map.s_low = s_low, map.step = step, map.columns = columns;
  map.rows = std::max(1, static_cast<int>(std::ceil((s_high - s_low) / step)));
  const std::size_t cells = static_cast<std::size_t>(map.rows) * static_cast<std::size_t>(columns);
  struct Entry {
    std::size_t cell;
    double r;
    int sample;
  };
  std::vector<Entry> entries;
  std::vector<double> outermost(cells, -1.0);
  for (int m : members) {
    const LimbPoint p = axis.locate(samples.positions[m]);
    const int i = static_cast<int>(std::floor((p.s - s_low) / step));
    if (i < 0 || i >= map.rows) continue;
    if (samples.normals[m].dot(axis.radial(p.s, p.phi)) < min_facing) continue;
    const int j = static_cast<int>((p.phi + std::numbers::pi) / (2 * std::numbers::pi) * columns);
    const std::size_t cell = map.index(i, std::min(j, columns - 1));
    entries.push_back({cell, p.r, m});
    outermost[cell] = std::max(outermost[cell], p.r);
  }
  map.radius.assign(cells, 0.0);
  map.count.assign(cells, 0);
  if (!samples.colours.empty()) map.colour.assign(cells, Vec3::Zero());
  for (const Entry& e : entries) {
    if (e.r < outermost[e.cell] - kLayer) continue;
    map.radius[e.cell] += e.r;
    ++map.count[e.cell];
    if (!map.colour.empty()) map.colour[e.cell] += samples.colours[e.sample];
  }
  for (std::size_t c = 0; c < cells; ++c) {
    if (map.count[c] == 0) {
      map.radius[c] = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    map.radius[c] /= map.count[c];
    if (!map.colour.empty()) map.colour[c] /= map.count[c];
  }
  return map;
}

}  // namespace regarment
