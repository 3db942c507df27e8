#include "measure/level_loops.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr double kReach = 0.008;       // m from the curve within which a column's evidence counts
constexpr double kFade = 0.3;          // evidence lost at that distance
constexpr double kWaveStep = 0.01;     // m between amplitudes that are tried
constexpr double kTypicalTilt = 0.02;  // m, amplitude that costs kWaveCost of evidence
constexpr double kWaveCost = 0.03;
constexpr double kLeast = -0.3, kMost = 1.2;  // a column's evidence is cut off there: no part of
                                              // the loop outvotes the rest

/// Best evidence near each boundary, column by column.
std::vector<double> pooled(const EdgeEvidence& e, double step) {
  const int reach = std::max(1, static_cast<int>(std::lround(kReach / step)));
  std::vector<double> out(e.score.size(), kLeast);
  for (int j = 0; j < e.columns; ++j)
    for (int i = 0; i < e.rows; ++i)
      for (int k = -reach; k <= reach; ++k) {
        if (i + k < 0 || i + k >= e.rows) continue;
        const double fade = kFade * k * k / (reach * reach);
        double& best = out[e.index(i, j)];
        best = std::max(best, std::min(kMost, e.score[e.index(i + k, j)]) - fade);
      }
  return out;
}

struct Wave {
  double a = 0, b = 0, c = 0;  // rows
  double cost = 0;
};

std::vector<Wave> waves(const EdgeSearch& search, double step) {
  const auto count = [](double most) { return static_cast<int>(std::lround(most / kWaveStep)); };
  const double rows = kWaveStep / step;
  const double unit = kWaveStep / kTypicalTilt;
  std::vector<Wave> out;
  for (int a = -count(search.tilt); a <= count(search.tilt); ++a)
    for (int b = -count(search.tilt); b <= count(search.tilt); ++b)
      for (int c = 0; c <= count(search.dip); ++c)
        out.push_back(
            {a * rows, b * rows, c * rows, kWaveCost * unit * unit * (a * a + b * b + c * c)});
  return out;
}

std::vector<double> shape(const Wave& wave, const LimbMap& map) {
  std::vector<double> out;
  for (int j = 0; j < map.columns; ++j) {
    const double phi = map.column_phi(j);
    out.push_back(wave.a * std::cos(phi) + wave.b * std::sin(phi) + wave.c * std::cos(2 * phi));
  }
  return out;
}

}  // namespace

std::vector<LevelLoop> level_loops(const EdgeEvidence& e, const LimbMap& map,
                                   const EdgeSearch& search, int most) {
  const std::vector<double> score = pooled(e, map.step);
  std::vector<double> best(e.rows, -1e9);
  std::vector<Wave> wave_at(e.rows);
  std::vector<int> offset(e.columns);
  for (const Wave& wave : waves(search, map.step)) {
    const std::vector<double> rows = shape(wave, map);
    for (int j = 0; j < e.columns; ++j) offset[j] = static_cast<int>(std::lround(rows[j]));
    for (int i = 0; i < e.rows; ++i) {
      double sum = 0;
      for (int j = 0; j < e.columns; ++j) {
        const int k = i + offset[j];
        sum += k >= 0 && k < e.rows ? score[e.index(k, j)] : kLeast;
      }
      sum = sum / e.columns - wave.cost;
      if (sum > best[i]) best[i] = sum, wave_at[i] = wave;
    }
  }
  std::vector<LevelLoop> loops;
  const double apart = kApart / map.step;
  while (static_cast<int>(loops.size()) < most) {
    const auto top = std::max_element(best.begin(), best.end());
    if (*top < -1e8) break;
    const int at = static_cast<int>(top - best.begin());
    LevelLoop loop{shape(wave_at[at], map), *top};
    for (double& row : loop.row) row = std::clamp(row + at, 0.0, e.rows - 1.0);
    loops.push_back(std::move(loop));
    for (int i = 0; i < e.rows; ++i)
      if (std::abs(i - at) < apart) best[i] = -1e9;
  }
  return loops;
}

void keep_near(const LevelLoop& loop, double rows, EdgeEvidence& e) {
  for (int j = 0; j < e.columns; ++j)
    for (int i = 0; i < e.rows; ++i)
      if (std::abs(i - loop.row[j]) > rows) e.score[e.index(i, j)] = kLeftOut;
}

}  // namespace regarment
