#include "measure/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/median.h"
#include "measure/outline_field.h"
#include "measure/point_buckets.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAverage = 0.004;  // m, points this close are averaged before they are followed
constexpr double kLargest = 3.0;    // m, a larger slice is no garment
constexpr double kBridgeSpacing = 0.003;
constexpr double kMostReach = 0.045;  // m, a wider gap is no gap between points
constexpr double kWider = 1.5;        // a reach against the one before
// The neighbourhood over which the outline is averaged: a share of the reach, and so many times the
// points' scatter about the curve, so that what is left of the noise is short against it.
constexpr double kNearShare = 0.42, kScatterFactor = 5.0;
constexpr double kLargestNear = 0.015;  // m
constexpr double kSmoothShare = 0.3;    // of the neighbourhood, smoothed over at the end
constexpr double kVertexSpacing = 0.002;

std::vector<Vec2> averaged(const std::vector<Vec2>& points) {
  const PointBuckets buckets(points, kAverage);
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const Vec2& p : points) {
    Vec2 sum = Vec2::Zero();
    double n = 0;
    buckets.near(p, [&](const Vec2& q) {
      if ((q - p).squaredNorm() <= kAverage * kAverage) sum += q, n += 1;
    });
    out.push_back(sum / n);
  }
  return out;
}

/// Points along straight lines over the gaps of the outermost points seen from `centre`.
std::vector<Vec2> bridges(const std::vector<Vec2>& points, const Vec2& centre, double reach) {
  constexpr int kBins = 180;
  std::array<double, kBins> most;
  most.fill(-1);
  std::array<Vec2, kBins> outer;
  for (const Vec2& p : points) {
    const Vec2 d = p - centre;
    const int bin = std::clamp(
        static_cast<int>((std::atan2(d.y(), d.x()) + kPi) / (2 * kPi) * kBins), 0, kBins - 1);
    if (d.norm() > most[bin]) most[bin] = d.norm(), outer[bin] = p;
  }
  std::vector<Vec2> ring, added;
  std::vector<int> at;
  for (int b = 0; b < kBins; ++b)
    if (most[b] >= 0) ring.push_back(outer[b]), at.push_back(b);
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const int step = (at[j] - at[i] + kBins) % kBins;
    const double length = (ring[j] - ring[i]).norm();
    if (step <= 1 || length < 2 * reach) continue;
    for (double t = kBridgeSpacing; t < length; t += kBridgeSpacing)
      added.push_back(ring[i] + t / length * (ring[j] - ring[i]));
  }
  return added;
}

double closed(const std::vector<Vec2>& curve) {
  double length = 0;
  for (std::size_t i = 0; i < curve.size(); ++i)
    length += (curve[(i + 1) % curve.size()] - curve[i]).norm();
  return length;
}

/// The closed curve again with vertices at even distances of about kVertexSpacing.
std::vector<Vec2> evenly(const std::vector<Vec2>& curve) {
  const double length = closed(curve);
  const auto count = static_cast<std::size_t>(std::max(8.0, std::ceil(length / kVertexSpacing)));
  std::vector<Vec2> out;
  double passed = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec2 step = curve[(i + 1) % curve.size()] - curve[i];
    const double way = step.norm();
    while (out.size() < count) {
      const double at = length * static_cast<double>(out.size()) / static_cast<double>(count);
      if (at > passed + way) break;
      out.push_back(way > 0 ? Vec2(curve[i] + (at - passed) / way * step) : curve[i]);
    }
    passed += way;
  }
  return out;
}

/// Points near a place: their weighted mean and main direction.
struct Neighbourhood {
  Vec2 mean = Vec2::Zero(), along = Vec2::UnitX();
  double scatter = 0;  // m, across the main direction
  double weight = 0;

  Neighbourhood(const PointBuckets& points, const Vec2& place, double size) {
    Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
    points.near(place, [&](const Vec2& q) {
      const double far = (q - place).squaredNorm() / (size * size);
      if (far >= 1) return;
      const double w = (1 - far) * (1 - far);
      weight += w, mean += w * (q - place), moment += w * (q - place) * (q - place).transpose();
    });
    if (weight <= 0) return;
    mean /= weight;
    const Eigen::Matrix2d spread = moment / weight - mean * mean.transpose();
    const double half = (spread(0, 0) - spread(1, 1)) / 2;
    const double turn = 0.5 * std::atan2(spread(0, 1), half);
    along = Vec2(std::cos(turn), std::sin(turn));
    const double middle = (spread(0, 0) + spread(1, 1)) / 2;
    scatter = std::sqrt(std::max(0.0, middle - std::hypot(half, spread(0, 1))));
    mean += place;
  }
  Vec2 foot(const Vec2& p) const { return mean + along.dot(p - mean) * along; }
};

/// Every vertex moved onto the points: first onto the nearest one, then onto the line through its
/// neighbourhood.
std::vector<Vec2> settled(const std::vector<Vec2>& curve, const std::vector<Vec2>& points,
                          double reach, double size) {
  const PointBuckets far(points, 1.5 * reach), near(points, size);
  std::vector<Vec2> out;
  for (const Vec2& c : curve) {
    double best = 2.25 * reach * reach;
    Vec2 at = c;
    far.near(c, [&](const Vec2& q) {
      if ((q - c).squaredNorm() < best) best = (q - c).squaredNorm(), at = q;
    });
    for (int round = 0; round < 2; ++round) {
      const Neighbourhood around(near, at, size);
      if (around.weight > 0) at = around.foot(at);
    }
    out.push_back(at);
  }
  return out;
}

double median_scatter(const std::vector<Vec2>& curve, const std::vector<Vec2>& points,
                      double size) {
  const PointBuckets near(points, size);
  std::vector<double> all;
  for (const Vec2& c : curve) all.push_back(Neighbourhood(near, c, size).scatter);
  return median(all);
}

std::vector<Vec2> smooth(const std::vector<Vec2>& curve, std::size_t half) {
  const std::size_t n = curve.size();
  std::vector<Vec2> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t k = 0; k <= 2 * half; ++k) sum += curve[(i + n + k - half) % n];
    out[i] = sum / static_cast<double>(2 * half + 1);
  }
  return out;
}

/// Share of the curve's vertices nearer to a bridge's points than to any other.
double share_on(const std::vector<Vec2>& curve, const std::vector<Vec2>& bridge,
                const std::vector<Vec2>& points, double reach) {
  if (bridge.empty()) return 0;
  const PointBuckets a(bridge, 2 * reach), b(points, 2 * reach);
  const auto nearest = [&](const PointBuckets& some, const Vec2& c) {
    double best = 4 * reach * reach;
    some.near(c, [&](const Vec2& q) { best = std::min(best, (q - c).squaredNorm()); });
    return best;
  };
  const auto on = std::count_if(curve.begin(), curve.end(),
                                [&](const Vec2& c) { return nearest(a, c) < nearest(b, c); });
  return static_cast<double>(on) / static_cast<double>(curve.size());
}

}  // namespace

double Outline::length() const { return closed(points); }

Outline trace_outline(const std::vector<Vec2>& points, const Vec2& centre, double reach) {
  if (points.size() < 12) return {};
  Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
  for (const Vec2& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  if ((high - low).maxCoeff() > kLargest) return {};
  std::vector<Vec2> followed = averaged(points);
  const std::vector<Vec2> bridge = bridges(followed, centre, reach);
  followed.insert(followed.end(), bridge.begin(), bridge.end());
  std::vector<Vec2> all = points;
  all.insert(all.end(), bridge.begin(), bridge.end());
  const double finest = kNearShare * reach;
  // Through a gap in a fold both sides of the curve would be measured.
  OutlineField field(followed, reach);
  while (field.leaks(centre) && reach * kWider <= kMostReach) {
    reach *= kWider;
    field = OutlineField(followed, reach);
  }
  if (field.leaks(centre)) return {};
  const std::vector<Vec2> contour = field.contour(centre);
  if (contour.size() < 12) return {};
  std::vector<Vec2> curve = evenly(contour);
  const std::vector<Vec2> first = settled(curve, all, reach, 2 * finest);
  const double size = std::clamp(kScatterFactor * median_scatter(first, all, 2 * finest),
                                 2 * finest, std::max(2 * finest, kLargestNear));
  curve = evenly(smooth(settled(curve, all, reach, size), 2));
  curve = smooth(curve, static_cast<std::size_t>(kSmoothShare * size / kVertexSpacing));
  return {curve, share_on(curve, bridge, points, reach)};
}

double outline_length(const std::vector<Vec2>& points, const Vec2& centre, double reach,
                      double* bridged) {
  const Outline outline = trace_outline(points, centre, reach);
  if (bridged) *bridged = outline.bridged;
  return outline.length();
}

}  // namespace regarment
