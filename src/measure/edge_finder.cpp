#include "measure/edge_finder.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/median.h"
#include "measure/edge_evidence.h"
#include "measure/level_loops.h"

namespace regarment {
namespace {

constexpr double kSlopePenalty = 0.15;  // evidence lost for moving one row, growing with its square
constexpr double kFaintest = 0.4;       // of evidence: errors grow no further below it
constexpr double kDropStep = 0.02;      // m, step said of cloth above nothing
constexpr double kDropFrom = 0.012;     // m, a step so large is a drop
constexpr double kThinCloth = 0.002, kMostEven = 1.3;  // m: even thin cloth stands off as much;
                                                       // what a column counts at most
constexpr int kLowColumns = 15;        // % of the columns, those that stand off least
constexpr double kLeastStep = 0.0015;  // m that the best of them stand off at an edge
constexpr double kLeastWeight = 0.6;   // what that counts
constexpr double kStray = 0.01;  // m, scale at which a column stops counting for the straight curve

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

/// See FoundEdge::even_score. Looks along the smooth edge `s`: a path that takes the best row of
/// every column finds steps anywhere in folds.
double even_score(const LimbMap& map, const EdgeEvidence& e, const std::vector<double>& s) {
  std::vector<double> stands_off;  // m, where the scan shows both sides, or a drop
  double sum = 0;
  for (int j = 0; j < e.columns; ++j) {
    const int row = static_cast<int>(std::lround((s[j] - map.s_low) / map.step)) - e.low;
    const EdgeBoundary& b = e.boundary[e.index(std::clamp(row, 0, e.rows - 1), j)];
    if (!b.valid) continue;
    stands_off.push_back(b.drop ? kDropStep : b.step);
    sum += b.drop ? b.filled : std::clamp(b.step / kThinCloth, -1.0, kMostEven);
  }
  if (stands_off.size() < 3) return 0;
  std::sort(stands_off.begin(), stands_off.end());
  const double least = stands_off[stands_off.size() * kLowColumns / 100];
  return sum / e.columns + kLeastWeight * std::clamp(least / kLeastStep, -1.0, 1.0);
}

/// The closed loop of largest summed evidence, a row per column.
std::vector<int> closed_path(const EdgeEvidence& e, int max_slope) {
  const std::vector<int> twice =
      best_path(e.score, e.rows, e.columns, 0, 2 * e.columns, -1, max_slope);
  const int anchor = twice[e.columns];
  return best_path(e.score, e.rows, e.columns, 0, e.columns + 1, anchor, max_slope);
}

/// Takes the evidence about a loop away, so that another one is found.
void leave_out(const std::vector<int>& path, double rows, EdgeEvidence& e) {
  for (int j = 0; j < e.columns; ++j)
    for (int i = 0; i < e.rows; ++i)
      if (std::abs(i - path[j]) < rows) e.score[e.index(i, j)] = kLeftOut;
}

/// Rows from a boundary to the top of the parabola through its evidence and its neighbours'.
double within_row(const EdgeEvidence& e, int i, int j) {
  if (i < 1 || i + 1 >= e.rows) return 0;
  const double a = e.score[e.index(i - 1, j)], m = e.score[e.index(i, j)],
               c = e.score[e.index(i + 1, j)];
  const double bend = a - 2 * m + c;
  return bend < -1e-6 ? std::clamp(0.5 * (a - c) / bend, -0.5, 0.5) : 0.0;
}

/// Puts what strays from a smooth curve on it.
void straighten(const LimbMap& map, double straightness, FoundEdge& edge) {
  const std::vector<double> straight = two_waves(edge.s, edge.seen);
  for (int j = 0; j < map.columns; ++j) {
    if (std::abs(edge.s[j] - straight[j]) <= straightness) continue;
    edge.s[j] = straight[j];
    edge.r[j] = outer_radius(map, straight[j], map.column_phi(j), 0.5);
    if (edge.r[j] < 0) edge.r[j] = edge.r[(j + map.columns - 1) % map.columns];
  }
}

FoundEdge edge_on_path(const LimbMap& map, const EdgeSearch& search, const EdgeEvidence& e,
                       const std::vector<int>& path) {
  FoundEdge edge;
  const int columns = map.columns;
  std::vector<double> steps, contrasts, drops;
  edge.s.resize(columns), edge.r.resize(columns), edge.step.assign(columns, 0.0);
  edge.seen.assign(columns, false);
  for (int j = 0; j < columns; ++j) {
    const EdgeBoundary& b = e.boundary[e.index(path[j], j)];
    const double score = e.score[e.index(path[j], j)];
    edge.s[j] = map.s_low + (e.low + path[j] + within_row(e, path[j], j)) * map.step;
    edge.r[j] = b.garment_r;
    edge.seen[j] = b.valid && score > kSeenShare;
    edge.score += score / columns;
    if (!edge.seen[j]) continue;
    edge.step[j] = b.drop ? kDropStep : b.step;
    steps.push_back(edge.step[j]);
    if (!b.drop) contrasts.push_back(b.contrast);
    drops.push_back(b.drop || b.step > kDropFrom);
  }
  edge.coverage = static_cast<double>(steps.size()) / columns;
  if (steps.size() < 3) return edge;
  fill_unseen(edge.s, edge.seen);
  fill_unseen(edge.r, edge.seen);
  if (search.straightness > 0) straighten(map, search.straightness, edge);
  const std::vector<double> smooth = smoothed(edge.s, 4);
  std::vector<double> residual;
  residual.reserve(edge.s.size());
  for (int j = 0; j < columns; ++j) residual.push_back(std::abs(edge.s[j] - smooth[j]));
  const double seen = static_cast<double>(steps.size());
  edge.standard_error = std::hypot(search.least_error / std::clamp(edge.score, kFaintest, 1.0),
                                   1.4826 * median(residual) / std::sqrt(std::max(1.0, seen / 5)));
  edge.s = smooth;
  edge.even_score = map.colour.empty() ? even_score(map, e, smooth) : edge.score;
  edge.typical_step = median(steps);
  edge.contrast = median(contrasts);
  edge.evidence = median(drops) > 0.5 ? "drop" : edge.contrast > kFullContrast ? "colour" : "step";
  return edge;
}

}  // namespace

double FoundEdge::mean_s() const {
  return std::accumulate(s.begin(), s.end(), 0.0) / static_cast<double>(s.size());
}

FoundEdge find_edge(const LimbMap& map, const EdgeSearch& search) {
  std::vector<FoundEdge> edges = find_edges(map, search, 1);
  return edges.empty() ? FoundEdge{} : std::move(edges.front());
}

std::vector<FoundEdge> find_edges(const LimbMap& map, const EdgeSearch& search, int most) {
  std::vector<FoundEdge> edges;
  EdgeEvidence evidence = edge_evidence(map, search);
  if (evidence.rows < 3) return edges;
  const std::vector<LevelLoop> loops =
      search.straightness > 0 ? level_loops(evidence, map, search, most) : std::vector<LevelLoop>{};
  const std::vector<double> all = evidence.score;
  for (int n = 0; n < most; ++n) {
    if (search.straightness > 0) {
      if (n >= static_cast<int>(loops.size())) break;
      evidence.score = all;
      keep_near(loops[n], search.straightness / map.step, evidence);
    }
    const std::vector<int> path = closed_path(evidence, search.max_slope);
    edges.push_back(edge_on_path(map, search, evidence, path));
    if (search.straightness <= 0) leave_out(path, kApart / map.step, evidence);
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const FoundEdge& a, const FoundEdge& b) { return a.score > b.score; });
  return edges;
}

std::vector<Vec3> edge_points(const FoundEdge& edge, const LimbMap& map, const LimbAxis& axis) {
  std::vector<Vec3> points;
  points.reserve(edge.s.size());
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
