#include "measure/hanging_folds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/median.h"
#include "geometry/point_tree.h"
#include "measure/garment_edges.h"

namespace regarment {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kBeside = 0.1;  // of the way round, on both sides: what a fold stands out from
constexpr double kStandsOut = 0.015;  // m
constexpr double kDeepest = 0.25;     // m, a fold hangs no lower below the hem
constexpr double kWidest = 0.6;       // m from the axis
constexpr double kAcross = 0.01;      // m between points of one surface, at least
constexpr double kSpacings = 2.0;     // the same in spacings of the samples
constexpr double kFacesOn = 0.3;      // cosine between their normals
constexpr double kRim = 0.8;          // a rim's or a cap's normal points downwards
constexpr double kAbove = 0.25;       // m above the hem that folds are followed to
constexpr double kCutOff = 0.02;      // m above the hem: what ends higher shows no hem
constexpr int kLeastRim = 5;    // cells that a fold reaches outwards, or the edge leaves it out
constexpr int kLeastCells = 4;  // of a fold

/// How far the hem and what is seen at each height stand out round every column.
class Surroundings {
 public:
  Surroundings(const LimbMap& map, const FoundEdge& edge)
      : map_(map), half_(std::max(2, static_cast<int>(kBeside * map.columns))) {
    std::vector<double> near;
    for (int j = 0; j < map.columns; ++j) {
      near.clear();
      for (int k = -half_; k <= half_; ++k) near.push_back(edge.r[wrapped(j + k)]);
      hem_.push_back(median(near));
    }
    rows_.assign(map.radius.size(), -1);
  }

  double radius(double s, int column) {
    const int row = std::clamp(static_cast<int>(std::lround(map_.row_of(s))), 0, map_.rows - 1);
    double& known = rows_[map_.index(row, column)];
    if (known < 0) {
      std::vector<double> near{0.0};
      for (int k = -half_; k <= half_; ++k)
        if (map_.has(row, column + k)) near.push_back(map_.radius[map_.index(row, column + k)]);
      known = median(near);
    }
    return std::max(known, hem_[column]);
  }

 private:
  int wrapped(int j) const { return (j + map_.columns) % map_.columns; }

  const LimbMap& map_;
  int half_;
  std::vector<double> hem_, rows_;  // m; rows_: -1 until asked for
};

struct Candidate {
  std::size_t sample;
  int column;
  double s, r;
  bool cloth;  // above the hem, on the trunk
};

std::vector<Candidate> candidates(const SurfaceSamples& samples, const Body& body,
                                  const LimbView& torso, const FoundEdge& hem,
                                  const std::vector<std::uint8_t>& taken, double top) {
  Surroundings round(torso.map, hem);
  std::vector<Candidate> out;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!taken.empty() && taken[i]) continue;
    if (body.part[i] != BodyPart::Trunk && body.part[i] != BodyPart::Loose) continue;
    if (samples.normals[i].y() < -kRim) continue;
    const LimbPoint at = torso.axis.locate(samples.positions[i]);
    const int column = torso.map.column_of(at.phi);
    const double below = hem.s[column] - at.s;
    if (at.s > std::min(top, hem.s[column] + kAbove) || below > kDeepest || at.r > kWidest)
      continue;
    const bool cloth = below < 0 && body.part[i] == BodyPart::Trunk;
    if (!cloth && at.r < round.radius(at.s, column) + kStandsOut) continue;
    out.push_back({i, column, at.s, at.r, cloth});
  }
  return out;
}

/// Which of what lies below an even surface joins to cloth above the hem; 0 for that cloth. There
/// is much more of it than of folds, so that it is these that look for cloth beside them.
std::vector<std::uint8_t> joined(const SurfaceSamples& samples, const std::vector<Candidate>& all) {
  std::vector<Vec3> points;
  points.reserve(all.size());
  for (const Candidate& c : all) points.push_back(samples.positions[c.sample]);
  const PointTree tree(points);
  std::vector<std::uint8_t> in(all.size(), 0);
  const double reach = std::max(kAcross, kSpacings * samples.spacing);
  std::vector<PointNeighbour> near;
  const auto beside = [&](std::size_t i, std::vector<std::size_t>& out) {
    tree.within(points[i], reach, near);
    out.clear();
    for (const PointNeighbour& other : near)
      if (!(samples.normals[all[i].sample].dot(samples.normals[all[other.index].sample]) <
            kFacesOn))
        out.push_back(other.index);
  };
  std::vector<std::size_t> todo, next;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].cloth) continue;
    beside(i, next);
    in[i] = std::any_of(next.begin(), next.end(), [&](std::size_t j) { return all[j].cloth; });
    if (in[i]) todo.push_back(i);
  }
  while (!todo.empty()) {
    const std::size_t i = todo.back();
    todo.pop_back();
    beside(i, next);
    for (const std::size_t j : next)
      if (!in[j] && !all[j].cloth) in[j] = 1, todo.push_back(j);
  }
  return in;
}

/// Where a fold's lower rim lies: between its columns, by distance from the axis.
std::vector<Vec3> rim_of(const GarmentEdge& edge, const LimbView& view, int first, int last) {
  const HangingFolds& folds = edge.folds;
  std::vector<Vec3> out;
  for (int k = 0; k < folds.cells; ++k) {
    Vec3 sum = Vec3::Zero();
    double n = 0;
    const double r = (k + 0.5) * HangingFolds::kStep;
    for (int j = first; j <= last; ++j) {
      const int column = j % view.map.columns;
      const double s = folds.at(column, r);
      if (std::isnan(s) || s > edge.found.s[column] + kCutOff) continue;
      sum += view.axis.point({s, view.map.column_phi(column), r}), n += 1;
    }
    if (n > 0) out.push_back(sum / n);
  }
  return out;
}

bool has_fold(const HangingFolds& folds, int column) {
  const auto first = folds.lowest.begin() + static_cast<std::ptrdiff_t>(column) * folds.cells;
  return std::any_of(first, first + folds.cells, [](double s) { return !std::isnan(s); });
}

}  // namespace

double HangingFolds::at(int column, double r) const {
  if (empty()) return kNone;
  const int cell = static_cast<int>(r / kStep);
  if (cell < 0 || cell >= cells) return kNone;
  return lowest[static_cast<std::size_t>(column) * static_cast<std::size_t>(cells) +
                static_cast<std::size_t>(cell)];
}

HangingFolds find_hanging_folds(const SurfaceSamples& samples, const Body& body,
                                const LimbView& torso, const GarmentEdge& edge,
                                const std::vector<std::uint8_t>& taken, double top) {
  HangingFolds folds;
  folds.cells = static_cast<int>(kWidest / HangingFolds::kStep) + 1;
  folds.lowest.assign(
      static_cast<std::size_t>(torso.map.columns) * static_cast<std::size_t>(folds.cells), kNone);
  const std::vector<Candidate> all = candidates(samples, body, torso, edge.found, taken, top);
  const std::vector<std::uint8_t> in = joined(samples, all);
  int found = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!in[i] || all[i].cloth) continue;
    const auto cell = static_cast<std::size_t>(all[i].r / HangingFolds::kStep);
    double& lowest = folds.lowest[static_cast<std::size_t>(all[i].column) *
                                      static_cast<std::size_t>(folds.cells) +
                                  cell];
    found += std::isnan(lowest) ? 1 : 0;
    lowest = std::isnan(lowest) ? all[i].s : std::min(lowest, all[i].s);
  }
  return found >= kLeastCells ? folds : HangingFolds{};
}

std::vector<Vec3> edge_curve(const GarmentEdge& edge, const LimbView& view) {
  std::vector<Vec3> points = edge_points(edge.found, view.map, view.axis);
  const int n = view.map.columns;
  int start = 0;
  if (!edge.folds.empty())
    while (start < n && has_fold(edge.folds, start)) ++start;
  if (edge.folds.empty() || start == n) return points;
  std::vector<Vec3> out;
  for (int j = start; j < start + n; ++j) {
    if (!has_fold(edge.folds, j % n)) {
      out.push_back(points[static_cast<std::size_t>(j % n)]);
      continue;
    }
    int last = j;
    while (last + 1 < start + n && has_fold(edge.folds, (last + 1) % n)) ++last;
    const std::vector<Vec3> rim = rim_of(edge, view, j, last);
    if (static_cast<int>(rim.size()) < kLeastRim) {
      for (; j <= last; ++j) out.push_back(points[static_cast<std::size_t>(j % n)]);
      j = last;
      continue;
    }
    out.insert(out.end(), rim.begin(), rim.end());
    out.insert(out.end(), rim.rbegin(), rim.rend());
    j = last;
  }
  return out;
}

}  // namespace regarment
