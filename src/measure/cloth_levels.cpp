#include "measure/cloth_levels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/parallel.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
// Columns on both sides over which heights of edges are averaged: wide ones leave out what folds do
// to an edge, narrow ones keep the corners at the side seams.
constexpr int kWide = 9, kNarrow = 5;
constexpr double kCorner = 0.005;  // m, narrow waves much higher than this are folds'
constexpr double kWindow = 0.01;   // m up and down over which the radius is averaged
constexpr double kRise = 0.005;    // m of height, nearly, between the entries of a way
// Entries over which the steepness is taken: what is left of the noise must not lengthen the way.
constexpr int kStride = 6;
constexpr double kMostBridged = 0.4;  // of a girth that may run over gaps

/// A place round the limb between two columns.
struct Between {
  int a, b;
  double share;  // of b

  Between(double phi, int columns) {
    const double c = (phi + kPi) / (2 * kPi) * columns - 0.5;
    const double low = std::floor(c);
    share = c - low;
    a = ((static_cast<int>(low) % columns) + columns) % columns;
    b = (a + 1) % columns;
  }
};

std::vector<double> averaged_round(const std::vector<double>& v, int half) {
  const int n = static_cast<int>(v.size());
  std::vector<double> out;
  for (int j = 0; j < n; ++j) {
    double sum = 0;
    for (int k = -half; k <= half; ++k) sum += v[((j + k) % n + n) % n];
    out.push_back(sum / (2 * half + 1));
  }
  return out;
}

/// Heights of an edge without the waves that folds make.
std::vector<double> calm(const std::vector<double>& s) {
  std::vector<double> wide = averaged_round(s, kWide), narrow = averaged_round(s, kNarrow);
  double waves = 0;
  for (std::size_t j = 0; j < s.size(); ++j)
    waves += std::pow(narrow[j] - wide[j], 2) / static_cast<double>(s.size());
  const double share = 1 / (1 + std::pow(waves / (kCorner * kCorner), 2));
  for (std::size_t j = 0; j < s.size(); ++j) wide[j] += share * (narrow[j] - wide[j]);
  return wide;
}

/// Mean outer radius of a column near a height; negative without data.
double radius_near(const LimbMap& map, double s, int column) {
  const int rows = std::max(1, static_cast<int>(std::lround(kWindow / map.step)));
  const int middle = static_cast<int>(std::lround(map.row_of(s)));
  double sum = 0, n = 0;
  for (int i = std::max(0, middle - rows); i <= std::min(map.rows - 1, middle + rows); ++i)
    for (int j = column - 1; j <= column + 1; ++j)
      if (map.has(i, j)) sum += map.radius[map.index(i, j)], n += 1;
  return n > 0 ? sum / n : -1;
}

/// Way over the surface in a column, in `count` steps of height `rise` (with its sign) from
/// `start`.
std::vector<double> way_of(const LimbMap& map, int column, double start, double rise, int count) {
  std::vector<double> radius, way{0.0};
  for (int i = 0; i <= count; ++i) radius.push_back(radius_near(map, start + i * rise, column));
  double slope = 0;
  for (int i = 1; i <= count; ++i) {
    const int before = std::max(0, i - kStride);
    if (radius[i] > 0 && radius[before] > 0)
      slope = (radius[i] - radius[before]) / ((i - before) * rise);
    way.push_back(way.back() + std::abs(rise) * std::hypot(1, slope));
  }
  return way;
}

}  // namespace

ClothLevels::ClothLevels(const LimbView& view, const GarmentEdge& edge, const GarmentEdge* opposite,
                         double length, double most)
    : view_(view), sign_(edge.garment_above ? 1.0 : -1.0), start_(calm(edge.found.s)) {
  const int n = view.map.columns;
  const std::vector<double> end = opposite ? calm(opposite->found.s) : std::vector<double>{};
  double sum = 0;
  for (int j = 0; j < n; ++j) {
    const double span = opposite ? std::max(kRise, sign_ * (end[j] - start_[j])) : most;
    const int count = std::max(1, static_cast<int>(std::lround(span / kRise)));
    rise_.push_back(span / count);
    ways_.push_back(way_of(view.map, j, start_[j], sign_ * rise_.back(), count));
    sum += ways_.back().back() / n;
  }
  length_ = opposite ? (length > 0 ? length : sum) : most;
  if (!opposite) {
    // Ways down into folds and over them differ; levels of the cloth do not follow them.
    std::vector<std::vector<double>> even(ways_.size(), std::vector<double>(ways_[0].size(), 0.0));
    for (int j = 0; j < n; ++j)
      for (int k = -kWide; k <= kWide; ++k)
        for (std::size_t i = 0; i < even[j].size(); ++i)
          even[j][i] += ways_[((j + k) % n + n) % n][i] / (2 * kWide + 1);
    ways_ = std::move(even);
    return;
  }
  for (auto& way : ways_) {
    const double scale = length_ / way.back();
    for (double& w : way) w *= scale;
  }
}

double ClothLevels::at_column(int column, double s) const {
  const std::vector<double>& way = ways_[column];
  const double rise = rise_[column], i = sign_ * (s - start_[column]) / rise;
  if (i <= 0) return i * rise;
  const auto last = static_cast<double>(way.size() - 1);
  if (i >= last) return way.back() + (i - last) * rise;
  const auto k = static_cast<std::size_t>(i);
  const double share = i - static_cast<double>(k);
  return (1 - share) * way[k] + share * way[k + 1];
}

double ClothLevels::height_at_column(int column, double t) const {
  const std::vector<double>& way = ways_[column];
  const double rise = rise_[column];
  const auto next = std::upper_bound(way.begin(), way.end(), t);
  double i = 0;
  if (next == way.begin())
    i = t / rise;
  else if (next == way.end())
    i = static_cast<double>(way.size() - 1) + (t - way.back()) / rise;
  else
    i = static_cast<double>(next - way.begin()) - (*next - t) / (*next - *(next - 1));
  return start_[column] + sign_ * i * rise;
}

double ClothLevels::level(const Vec3& p) const {
  const LimbPoint at = view_.axis.locate(p);
  const Between where(at.phi, view_.map.columns);
  return (1 - where.share) * at_column(where.a, at.s) + where.share * at_column(where.b, at.s);
}

double ClothLevels::height(double t, double phi) const {
  const Between where(phi, view_.map.columns);
  return (1 - where.share) * height_at_column(where.a, t) +
         where.share * height_at_column(where.b, t);
}

std::vector<LevelGirth> level_girths(const SurfaceSamples& samples, const std::vector<int>& cloth,
                                     const LimbView& view, const ClothLevels& levels, double from,
                                     double to, double step, double half, double reach) {
  std::vector<std::pair<double, int>> order;
  order.reserve(cloth.size());
  for (const int m : cloth) order.emplace_back(levels.level(samples.positions[m]), m);
  std::sort(order.begin(), order.end());
  std::vector<double> at;
  for (double t = from; t <= to + 1e-9; t += step) at.push_back(t);
  std::vector<std::optional<LevelGirth>> found(at.size());
  const auto measure = [&](double t) -> std::optional<LevelGirth> {
    const Vec3 centre = view.axis.point({levels.height(t, 0.0), 0, 0});
    std::vector<Vec2> points;
    for (auto it = std::lower_bound(order.begin(), order.end(), std::pair(t - half, -1));
         it != order.end() && it->first < t + half; ++it) {
      const Vec3 d = samples.positions[it->second] - centre;
      points.emplace_back(d.z(), d.x());
    }
    const Outline outline = trace_outline(points, Vec2::Zero(), reach);
    if (outline.points.empty() || outline.bridged > kMostBridged) return std::nullopt;
    const auto lifted = [&](const Vec2& p) {
      return Vec3(p.x(), p.y(), levels.height(t, std::atan2(p.y(), p.x())));
    };
    double girth = 0;
    for (std::size_t i = 0; i < outline.points.size(); ++i)
      girth += (lifted(outline.points[(i + 1) % outline.points.size()]) - lifted(outline.points[i]))
                   .norm();
    return LevelGirth{t, girth, outline.bridged};
  };
  parallel_for(at.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = measure(at[i]);
  });
  std::vector<LevelGirth> out;
  for (const std::optional<LevelGirth>& level : found)
    if (level) out.push_back(*level);
  return out;
}

}  // namespace regarment
