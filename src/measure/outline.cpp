#include "measure/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kCell = 0.002;  // m, of the distance field
constexpr double kAverage =
    0.004;                        // m, points this close are averaged: noise makes outlines longer
constexpr double kLargest = 3.0;  // m, a larger slice is no garment
constexpr double kBridgeSpacing = 0.003;
constexpr double kHeart = 0.03;       // m round the centre that the outside must not hold
constexpr double kMostReach = 0.045;  // m, a wider gap is no gap between points
constexpr double kWider = 1.5;        // a reach against the one before

/// Points by cells of `size`, for neighbourhoods no wider than that.
class Buckets {
 public:
  Buckets(const std::vector<Vec2>& points, const Vec2& low, const Vec2& high, double size)
      : points_(points), low_(low), size_(size) {
    nx_ = static_cast<int>((high.x() - low.x()) / size) + 1;
    ny_ = static_cast<int>((high.y() - low.y()) / size) + 1;
    first_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) + 1, 0);
    for (const Vec2& p : points) ++first_[cell(p) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    order_.resize(points.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      order_[next[cell(points[i])]++] = static_cast<int>(i);
  }
  template <typename Visit>
  void near(const Vec2& p, Visit visit) const {
    const int cx = static_cast<int>(std::floor((p.x() - low_.x()) / size_));
    const int cy = static_cast<int>(std::floor((p.y() - low_.y()) / size_));
    for (int y = std::max(0, cy - 1); y <= std::min(ny_ - 1, cy + 1); ++y)
      for (int x = std::max(0, cx - 1); x <= std::min(nx_ - 1, cx + 1); ++x) {
        const std::size_t c = static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
                              static_cast<std::size_t>(x);
        for (int k = first_[c]; k < first_[c + 1]; ++k) visit(points_[order_[k]]);
      }
  }

 private:
  std::size_t cell(const Vec2& p) const {
    const int x = std::clamp(static_cast<int>((p.x() - low_.x()) / size_), 0, nx_ - 1);
    const int y = std::clamp(static_cast<int>((p.y() - low_.y()) / size_), 0, ny_ - 1);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
           static_cast<std::size_t>(x);
  }
  const std::vector<Vec2>& points_;
  Vec2 low_;
  double size_;
  int nx_ = 0, ny_ = 0;
  std::vector<int> first_, order_;
};

struct Bounds {
  Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
  explicit Bounds(const std::vector<Vec2>& points, double margin) {
    for (const Vec2& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    low.array() -= margin;
    high.array() += margin;
  }
};

std::vector<Vec2> averaged(const std::vector<Vec2>& points) {
  const Bounds box(points, kAverage);
  const Buckets buckets(points, box.low, box.high, kAverage);
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

/// Adds points along straight lines over the gaps of the outermost points seen from `centre`.
/// Returns the length added.
double bridge_gaps(std::vector<Vec2>& points, const Vec2& centre, double reach) {
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
  std::vector<Vec2> ring;
  std::vector<int> at;
  for (int b = 0; b < kBins; ++b)
    if (most[b] >= 0) ring.push_back(outer[b]), at.push_back(b);
  double added = 0;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const int step = (at[j] - at[i] + kBins) % kBins;
    const double length = (ring[j] - ring[i]).norm();
    if (step <= 1 || length < 2 * reach) continue;
    added += length;
    for (double t = kBridgeSpacing; t < length; t += kBridgeSpacing)
      points.push_back(ring[i] + t / length * (ring[j] - ring[i]));
  }
  return added;
}

struct Field {
  Vec2 low = Vec2::Zero();  // of the grid
  int nx = 0, ny = 0;
  std::vector<float> distance;        // at grid points, capped at 2 reach
  std::vector<std::uint8_t> outside;  // 1: reached from the border at distance > reach
  std::vector<std::uint8_t> own;  // 1: not outside, and joined to the surroundings of the centre

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x);
  }
};

Field distance_field(const std::vector<Vec2>& points, double reach) {
  const double far = 2 * reach;
  const Bounds box(points, far + kCell);
  const Buckets buckets(points, box.low, box.high, far);
  Field f;
  f.low = box.low;
  f.nx = static_cast<int>((box.high.x() - box.low.x()) / kCell) + 2;
  f.ny = static_cast<int>((box.high.y() - box.low.y()) / kCell) + 2;
  f.distance.assign(static_cast<std::size_t>(f.nx) * static_cast<std::size_t>(f.ny),
                    static_cast<float>(far));
  const int r = static_cast<int>(far / kCell);
  for (const Vec2& p : points) {
    const int cx = static_cast<int>((p.x() - box.low.x()) / kCell);
    const int cy = static_cast<int>((p.y() - box.low.y()) / kCell);
    for (int y = std::max(0, cy - r); y <= std::min(f.ny - 1, cy + r + 1); ++y)
      for (int x = std::max(0, cx - r); x <= std::min(f.nx - 1, cx + r + 1); ++x) {
        const Vec2 g = box.low + kCell * Vec2(x, y);
        float& d = f.distance[f.at(x, y)];
        d = std::min(d, static_cast<float>((g - p).norm()));
      }
  }
  f.outside.assign(f.distance.size(), 0);
  std::vector<std::pair<int, int>> stack{{0, 0}};
  f.outside[0] = 1;
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const auto& s : kSteps) {
      const int u = x + s[0], v = y + s[1];
      if (u < 0 || v < 0 || u >= f.nx || v >= f.ny || f.outside[f.at(u, v)]) continue;
      if (f.distance[f.at(u, v)] <= static_cast<float>(reach)) continue;
      f.outside[f.at(u, v)] = 1;
      stack.emplace_back(u, v);
    }
  }
  return f;
}

/// Grid points near the centre.
std::vector<std::pair<int, int>> heart(const Field& f, const Vec2& centre) {
  const int cx = static_cast<int>((centre.x() - f.low.x()) / kCell);
  const int cy = static_cast<int>((centre.y() - f.low.y()) / kCell);
  const int r = static_cast<int>(kHeart / kCell);
  std::vector<std::pair<int, int>> out;
  for (int y = std::max(0, cy - r); y <= std::min(f.ny - 1, cy + r); ++y)
    for (int x = std::max(0, cx - r); x <= std::min(f.nx - 1, cx + r); ++x) out.emplace_back(x, y);
  return out;
}

/// Whether the outside has come in through a gap: it holds most of the surroundings of the centre.
bool leaks(const Field& f, const Vec2& centre) {
  const auto points = heart(f, centre);
  const auto outside = std::count_if(points.begin(), points.end(), [&](const auto& p) {
    return f.outside[f.at(p.first, p.second)] != 0;
  });
  return 2 * static_cast<std::size_t>(outside) > points.size();
}

/// Marks what belongs to the outline round the centre; other cloth that the plane cuts does not.
void mark_own(const Vec2& centre, Field& f) {
  f.own.assign(f.outside.size(), 0);
  std::vector<std::pair<int, int>> stack;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= f.nx || y >= f.ny) return;
    const std::size_t i = f.at(x, y);
    if (f.outside[i] || f.own[i]) return;
    f.own[i] = 1;
    stack.emplace_back(x, y);
  };
  for (const auto& [x, y] : heart(f, centre)) visit(x, y);
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    visit(x + 1, y), visit(x - 1, y), visit(x, y + 1), visit(x, y - 1);
  }
}

/// Length of the curve at distance `reach` that borders on the outside: marching squares.
double contour_length(const Field& f, double reach) {
  double length = 0;
  for (int y = 0; y + 1 < f.ny; ++y) {
    for (int x = 0; x + 1 < f.nx; ++x) {
      const std::array<std::pair<int, int>, 4> corner{
          {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
      std::array<Vec2, 4> crossing;
      int n = 0;
      bool touches = false, own = false;
      for (int k = 0; k < 4; ++k) {
        const auto [ax, ay] = corner[k];
        const auto [bx, by] = corner[(k + 1) % 4];
        const double a = static_cast<double>(f.distance[f.at(ax, ay)]) - reach;
        const double b = static_cast<double>(f.distance[f.at(bx, by)]) - reach;
        touches = touches || f.outside[f.at(ax, ay)] != 0;
        own = own || f.own[f.at(ax, ay)] != 0;
        if ((a > 0) == (b > 0)) continue;
        const double t = a / (a - b);
        crossing[n++] = (1 - t) * Vec2(ax, ay) + t * Vec2(bx, by);
      }
      if (!touches || !own) continue;
      if (n == 2) length += (crossing[1] - crossing[0]).norm();
      if (n == 4) length += (crossing[1] - crossing[0]).norm() + (crossing[3] - crossing[2]).norm();
    }
  }
  return length * kCell;
}

}  // namespace

double outline_length(const std::vector<Vec2>& points, const Vec2& centre, double reach,
                      double* bridged) {
  if (bridged) *bridged = 0;
  if (points.size() < 12) return 0;
  const Bounds box(points, 0);
  if ((box.high - box.low).maxCoeff() > kLargest) return 0;
  std::vector<Vec2> curve = averaged(points);
  const double added = bridge_gaps(curve, centre, reach);
  Field field = distance_field(curve, reach);
  // Through a gap in a fold both sides of the curve would be measured.
  while (leaks(field, centre) && reach * kWider <= kMostReach) {
    reach *= kWider;
    field = distance_field(curve, reach);
  }
  if (leaks(field, centre)) return 0;
  mark_own(centre, field);
  const double length = contour_length(field, reach) - 2 * kPi * reach;
  if (bridged && length > 0) *bridged = added / length;
  return std::max(0.0, length);
}

}  // namespace regarment
