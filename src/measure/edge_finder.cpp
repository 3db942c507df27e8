#include "measure/edge_finder.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kWindow = 0.028;       // m of surface looked at on each side of an edge
constexpr double kSkip = 0.004;         // m next to the edge left out: meshes round it off
constexpr double kDropEvidence = 1.0;   // evidence of cloth above nothing at all
constexpr double kFullContrast = 0.12;  // colour difference that counts as fully convincing
constexpr double kMostEvidence = 2.0;
constexpr double kSlopePenalty = 0.15;  // evidence lost for moving one row, growing with its square
constexpr double kStray = 0.01;  // m, scale at which a column stops counting for the straight curve
constexpr double kSeenShare = 0.3;  // of full evidence: the column shows the edge

/// What lies on both sides of one boundary between rows.
struct Boundary {
  double step = 0;       // m, garment surface minus the other at the boundary
  double garment_r = 0;  // m, garment surface extrapolated to the boundary
  double contrast = 0;
  bool drop = false;  // cloth on one side, nothing on the other
  double filled = 1;  // share of the garment's rows that hold data: all of them beside a drop
  bool valid = false;
};

struct SideSums {
  int n = 0;
  double x = 0, y = 0, xx = 0, xy = 0;
  Vec3 colour = Vec3::Zero();

  void add(double xi, double yi) { ++n, x += xi, y += yi, xx += xi * xi, xy += xi * yi; }
  double spread() const { return xx - x * x / n; }
  double covariance() const { return xy - x * y / n; }
};

int window_rows(const LimbMap& map) {
  return std::max(4, static_cast<int>(std::lround(kWindow / map.step)));
}

/// Sums over the rows of one side; `direction` +1 towards larger rows.
SideSums side_sums(const LimbMap& map, int boundary, int column, int direction) {
  SideSums sums;
  const int skip = static_cast<int>(std::lround(kSkip / map.step));
  const int rows = window_rows(map);
  for (int k = skip; k < skip + rows; ++k) {
    const int i = direction > 0 ? boundary + k : boundary - 1 - k;
    if (i < 0 || i >= map.rows || !map.has(i, column)) continue;
    const std::size_t cell = map.index(i, column);
    sums.add((i + 0.5 - boundary) * map.step, map.radius[cell]);
    if (!map.colour.empty()) sums.colour += map.colour[cell];
  }
  return sums;
}

/// Two parallel lines through the rows on both sides; their offset at the boundary is the step.
Boundary fit_boundary(const LimbMap& map, int boundary, int column, bool garment_above) {
  const SideSums garment = side_sums(map, boundary, column, garment_above ? 1 : -1);
  const SideSums other = side_sums(map, boundary, column, garment_above ? -1 : 1);
  Boundary b;
  if (garment.n < 3) return b;
  if (other.n < 3) {
    // A stray row or two beyond the edge make a drop less sure, not impossible.
    b.drop = b.valid = true;
    const int next = garment_above ? boundary : boundary - 1;
    const bool touches = next >= 0 && next < map.rows && map.has(next, column);
    b.filled = (garment.n + (touches ? 1 : 0) - other.n) / (window_rows(map) + 1.0);
    const double slope = garment.spread() > 0 ? garment.covariance() / garment.spread() : 0;
    b.garment_r = (garment.y - slope * garment.x) / garment.n;
    return b;
  }
  const double slope =
      (garment.covariance() + other.covariance()) / (garment.spread() + other.spread());
  b.garment_r = (garment.y - slope * garment.x) / garment.n;
  b.step = b.garment_r - (other.y - slope * other.x) / other.n;
  if (!map.colour.empty())
    b.contrast = (garment.colour / garment.n - other.colour / other.n).norm();
  b.valid = true;
  return b;
}

double evidence(const Boundary& b, const EdgeSearch& search, bool coloured) {
  if (!b.valid) return 0;
  if (b.drop) return kDropEvidence * b.filled;
  // Beyond a cloth's thickness evidence grows ever more slowly, but grows: its peak is the edge.
  double step = std::max(b.step / search.cloth_step, -1.0);
  if (step > 1) step = 1 + (step - 1) / (step + 1) * (kMostEvidence - 1);
  if (b.step > search.most_step) step = kSeenShare;  // a hand beside the edge, not cloth on skin
  if (!coloured) return step;
  return 0.5 * step + kMostEvidence * b.contrast / (b.contrast + kFullContrast);
}

/// Best path from column `first` over `count` columns; with `anchor` >= 0 it starts and ends there.
std::vector<int> best_path(const std::vector<double>& score, int rows, int columns, int first,
                           int count, int anchor, int max_slope) {
  const auto at = [&](int k, int i) {
    return score[static_cast<std::size_t>((first + k) % columns) * static_cast<std::size_t>(rows) +
                 static_cast<std::size_t>(i)];
  };
  constexpr double kNever = -1e18;
  std::vector<double> value(rows), next(rows);
  std::vector<std::vector<int>> from(count, std::vector<int>(rows, 0));
  for (int i = 0; i < rows; ++i) value[i] = anchor < 0 || i == anchor ? at(0, i) : kNever;
  for (int k = 1; k < count; ++k) {
    for (int i = 0; i < rows; ++i) {
      next[i] = kNever;
      for (int d = -max_slope; d <= max_slope; ++d) {
        if (i + d < 0 || i + d >= rows) continue;
        const double v = value[i + d] - kSlopePenalty * d * d;
        if (v > next[i]) next[i] = v, from[k][i] = i + d;
      }
      next[i] += at(k, i);
    }
    value.swap(next);
  }
  int i = static_cast<int>(std::max_element(value.begin(), value.end()) - value.begin());
  if (anchor >= 0) {
    for (int d = -1; d <= 1; ++d)
      if (anchor + d >= 0 && anchor + d < rows &&
          (d == -1 || value[anchor + d] > value[i] || std::abs(i - anchor) > 1))
        i = anchor + d;
  }
  std::vector<int> path(count);
  for (int k = count - 1; k >= 0; --k) {
    path[k] = i;
    if (k > 0) i = from[k][i];
  }
  return path;
}

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

/// Fills what was not seen from the nearest seen columns on both sides, linearly round the loop.
void fill_unseen(std::vector<double>& v, const std::vector<bool>& seen) {
  const int n = static_cast<int>(v.size());
  for (int j = 0; j < n; ++j) {
    if (seen[j]) continue;
    int back = 1, ahead = 1;
    while (back < n && !seen[(j - back + n) % n]) ++back;
    while (ahead < n && !seen[(j + ahead) % n]) ++ahead;
    if (back >= n) return;
    v[j] = (v[(j - back + n) % n] * ahead + v[(j + ahead) % n] * back) / (back + ahead);
  }
}

std::vector<double> smoothed(const std::vector<double>& v, int half) {
  const int n = static_cast<int>(v.size());
  std::vector<double> out(v.size());
  for (int j = 0; j < n; ++j) {
    std::vector<double> window;
    for (int k = -half; k <= half; ++k) window.push_back(v[(j + k + n) % n]);
    const double middle = median(window);
    double sum = 0, weight = 0;
    for (double w : window) {
      const double d = std::abs(w - middle);
      const double trust = d < 0.012 ? 1.0 : 0.0;
      sum += trust * w, weight += trust;
    }
    out[j] = sum / weight;
  }
  return out;
}

/// Robust curve of two waves round the limb through the seen columns (least squares, reweighted).
std::vector<double> two_waves(const std::vector<double>& s, const std::vector<bool>& seen) {
  const auto n = static_cast<Eigen::Index>(s.size());
  Eigen::MatrixXd waves(n, 5);
  Eigen::VectorXd value(n), weight(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double phi = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    waves.row(j) << 1, std::cos(phi), std::sin(phi), std::cos(2 * phi), std::sin(2 * phi);
    value[j] = s[static_cast<std::size_t>(j)];
    weight[j] = seen[static_cast<std::size_t>(j)] ? 1.0 : 0.05;
  }
  Eigen::VectorXd trust = weight, curve = value;
  for (int round = 0; round < 8; ++round) {
    const Eigen::MatrixXd weighted = trust.asDiagonal() * waves;
    const Eigen::VectorXd c =
        (waves.transpose() * weighted).ldlt().solve(weighted.transpose() * value);
    curve = waves * c;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double z = (value[j] - curve[j]) / kStray;
      trust[j] = weight[j] / ((1 + z * z) * (1 + z * z));
    }
  }
  return {curve.data(), curve.data() + n};
}

}  // namespace

FoundEdge find_edge(const LimbMap& map, const EdgeSearch& search) {
  FoundEdge edge;
  const int low = std::max(1, static_cast<int>(std::ceil((search.s_low - map.s_low) / map.step)));
  const int high =
      std::min(map.rows - 1, static_cast<int>(std::floor((search.s_high - map.s_low) / map.step)));
  const int rows = high - low + 1;
  if (rows < 3) return edge;
  const bool coloured = !map.colour.empty();
  std::vector<Boundary> boundary(static_cast<std::size_t>(rows) *
                                 static_cast<std::size_t>(map.columns));
  std::vector<double> score(boundary.size());
  for (int j = 0; j < map.columns; ++j) {
    for (int i = 0; i < rows; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * static_cast<std::size_t>(rows) +
                            static_cast<std::size_t>(i);
      boundary[k] = fit_boundary(map, low + i, j, search.garment_above);
      score[k] = evidence(boundary[k], search, coloured);
      if (search.spread > 0 && !search.centre.empty()) {
        const double z = (map.s_low + (low + i) * map.step - search.centre[j]) / search.spread;
        score[k] -= 0.1 * z * z;
      }
    }
  }
  const int columns = map.columns;
  const std::vector<int> twice =
      best_path(score, rows, columns, 0, 2 * columns, -1, search.max_slope);
  const int anchor = twice[columns];
  const std::vector<int> path =
      best_path(score, rows, columns, 0, columns + 1, anchor, search.max_slope);

  std::vector<double> steps, contrasts, drops;
  edge.s.resize(columns), edge.r.resize(columns), edge.step.assign(columns, 0.0);
  edge.seen.assign(columns, false);
  int seen = 0;
  for (int j = 0; j < columns; ++j) {
    const auto at = [&](int i) -> std::size_t {
      return static_cast<std::size_t>(j) * static_cast<std::size_t>(rows) +
             static_cast<std::size_t>(i);
    };
    const Boundary& b = boundary[at(path[j])];
    double offset = 0;  // rows, top of the parabola through the neighbours
    if (path[j] > 0 && path[j] + 1 < rows) {
      const double a = score[at(path[j] - 1)], c = score[at(path[j] + 1)], m = score[at(path[j])];
      const double bend = a - 2 * m + c;
      if (bend < -1e-6) offset = std::clamp(0.5 * (a - c) / bend, -0.5, 0.5);
    }
    edge.s[j] = map.s_low + (low + path[j] + offset) * map.step;
    edge.r[j] = b.garment_r;
    edge.seen[j] = b.valid && score[at(path[j])] > kSeenShare;
    edge.score += score[at(path[j])] / columns;
    if (!edge.seen[j]) continue;
    ++seen;
    edge.step[j] = b.drop ? 0.02 : b.step;
    steps.push_back(edge.step[j]);
    if (!b.drop) contrasts.push_back(b.contrast);
    drops.push_back(b.drop || b.step > 0.012);
  }
  edge.coverage = static_cast<double>(seen) / columns;
  if (seen < 3) return edge;
  fill_unseen(edge.s, edge.seen);
  fill_unseen(edge.r, edge.seen);
  if (search.straightness > 0) {
    const std::vector<double> straight = two_waves(edge.s, edge.seen);
    for (int j = 0; j < columns; ++j) {
      if (std::abs(edge.s[j] - straight[j]) <= search.straightness) continue;
      edge.s[j] = straight[j];
      edge.r[j] = outer_radius(map, straight[j], map.column_phi(j), 0.5);
      if (edge.r[j] < 0) edge.r[j] = edge.r[(j + columns - 1) % columns];
    }
  }
  const std::vector<double> smooth = smoothed(edge.s, 4);
  std::vector<double> residual;
  for (int j = 0; j < columns; ++j) residual.push_back(std::abs(edge.s[j] - smooth[j]));
  edge.standard_error = 1.4826 * median(residual) / std::sqrt(std::max(1.0, seen / 5.0));
  edge.s = smooth;
  edge.typical_step = median(steps);
  edge.contrast = median(contrasts);
  const double dropped = median(drops);
  edge.evidence = dropped > 0.5 ? "drop" : edge.contrast > kFullContrast ? "colour" : "step";
  return edge;
}

std::vector<Vec3> edge_points(const FoundEdge& edge, const LimbMap& map, const LimbAxis& axis) {
  std::vector<Vec3> points;
  for (int j = 0; j < static_cast<int>(edge.s.size()); ++j)
    points.push_back(axis.point({edge.s[j], map.column_phi(j), edge.r[j]}));
  return points;
}

double closed_length(const std::vector<Vec3>& points, int half_width) {
  const int n = static_cast<int>(points.size());
  std::vector<Vec3> smooth(points.size());
  for (int j = 0; j < n; ++j) {
    Vec3 sum = Vec3::Zero();
    for (int k = -half_width; k <= half_width; ++k) sum += points[((j + k) % n + n) % n];
    smooth[j] = sum / (2 * half_width + 1);
  }
  double length = 0;
  for (int j = 0; j < n; ++j) length += (smooth[(j + 1) % n] - smooth[j]).norm();
  return length;
}

}  // namespace regarment
