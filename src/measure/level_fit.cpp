#include "measure/level_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr std::size_t kLeast = 3;
constexpr int kRounds = 10;           // of weighing outliers down
constexpr double kScatter = 0.004;    // of a girth: what levels of well seen cloth differ by
constexpr double kNearStart = 0.03;   // m, levels nearer to the start say little of the growth
constexpr double kLeastShare = 0.25;  // of a piece that has to be seen well
constexpr double kEndWindow = 0.04;   // m
constexpr double kAbove = 0.015;      // of a girth that a level may lie above a straight growth
constexpr double kMostAbove = 0.25;   // of the levels that may lie further above it

}  // namespace

FittedGirth girth_at_level(const std::vector<LevelGirth>& levels, double t, double window) {
  std::vector<LevelGirth> near;
  std::size_t before = 0;
  for (const LevelGirth& l : levels) {
    if (std::abs(l.t - t) > window) continue;
    near.push_back(l);
    before += l.t < t;
  }
  if (near.size() < kLeast) return {};
  const bool bent = before >= kLeast && near.size() - before >= kLeast;
  const Eigen::Index n = static_cast<Eigen::Index>(near.size()), unknown = bent ? 3 : 2;
  Eigen::MatrixXd rows(n, unknown);
  Eigen::VectorXd girth(n), weight = Eigen::VectorXd::Ones(n), fitted(unknown);
  for (Eigen::Index i = 0; i < n; ++i) {
    const LevelGirth& l = near[static_cast<std::size_t>(i)];
    const double d = l.t - t;
    rows(i, 0) = 1, rows(i, 1) = bent ? std::min(d, 0.0) : d;
    if (bent) rows(i, 2) = std::max(d, 0.0);
    girth[i] = l.girth;
  }
  Eigen::VectorXd off(n);
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::MatrixXd weighted = weight.asDiagonal() * rows;
    fitted = (weighted.transpose() * rows).ldlt().solve(weighted.transpose() * girth);
    off = girth - rows * fitted;
    const double scale = kScatter * std::abs(fitted[0]) + 1e-6;
    for (Eigen::Index i = 0; i < n; ++i)
      weight[i] = 1 / (1 + std::pow(off[i] / scale, 2)) / (1 + 20 * near[i].bridged);
  }
  const double spread = std::sqrt(off.cwiseAbs2().dot(weight) / weight.sum());
  double bridged = 0;
  for (Eigen::Index i = 0; i < n; ++i) bridged += weight[i] * near[i].bridged / weight.sum();
  return {fitted[0], spread, 0, bridged, true};
}

FittedGirth girth_of_straight_piece(const std::vector<LevelGirth>& levels, double start,
                                    double girth_at_start, double t) {
  const double whole = std::abs(t - start);
  std::vector<LevelGirth> piece;  // from the start on; t is the way from there
  for (const LevelGirth& l : levels) {
    const double way = (l.t - start) * (t > start ? 1 : -1);
    if (way > kNearStart && way < whole) piece.push_back({way, l.girth, l.bridged});
  }
  std::sort(piece.begin(), piece.end(),
            [](const LevelGirth& a, const LevelGirth& b) { return a.t < b.t; });
  for (std::size_t last = piece.size(); last >= kLeast; --last) {
    const double way = piece[last - 1].t;
    if (way < kLeastShare * whole) break;
    const FittedGirth end = girth_at_level(piece, way, kEndWindow);
    if (!end.found) continue;
    const double slope = (end.value - girth_at_start) / way;
    // Levels above the straight line between start and end: the end misses cloth.
    double above = 0, spread = 0;
    for (std::size_t i = 0; i < last; ++i) {
      const double off = piece[i].girth - (girth_at_start + slope * piece[i].t);
      above += off > kAbove * piece[i].girth;
      spread += std::min(off * off, std::pow(kAbove * piece[i].girth, 2));
    }
    const auto n = static_cast<double>(last);
    if (above > kMostAbove * n) continue;
    return {girth_at_start + slope * whole, std::sqrt(spread / n), slope * (whole - way),
            end.bridged, true};
  }
  return {};
}

}  // namespace regarment
