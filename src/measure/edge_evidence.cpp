#include "measure/edge_evidence.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr double kWindow = 0.028;      // m of surface looked at on each side of an edge
constexpr double kSkip = 0.004;        // m next to the edge left out: meshes round it off
constexpr double kRecurs = 0.12;       // m beyond that within which a stripe's colour comes again
constexpr double kDropEvidence = 1.0;  // evidence of cloth above nothing at all
constexpr double kMostEvidence = 2.0;

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

/// How near the colours further up (or down) the column come to this one: a stripe's colour is
/// found again where the garment goes on.
double nearest_colour(const LimbMap& map, int boundary, int column, bool above,
                      const Vec3& colour) {
  const int from = static_cast<int>(std::lround(kSkip / map.step)) + window_rows(map);
  const int to = from + static_cast<int>(std::lround(kRecurs / map.step));
  double nearest = 2;
  for (int k = from; k + 1 < to; k += 2) {
    const int i = above ? boundary + k : boundary - 2 - k;
    if (i < 0 || i + 1 >= map.rows) break;
    if (!map.has(i, column) || !map.has(i + 1, column)) continue;
    const Vec3 mean =
        0.5 * (map.colour[map.index(i, column)] + map.colour[map.index(i + 1, column)]);
    nearest = std::min(nearest, (mean - colour).norm());
  }
  return nearest;
}

/// Two parallel lines through the rows on both sides; their offset at the boundary is the step.
EdgeBoundary fit_boundary(const LimbMap& map, int boundary, int column, bool garment_above) {
  const SideSums garment = side_sums(map, boundary, column, garment_above ? 1 : -1);
  const SideSums other = side_sums(map, boundary, column, garment_above ? -1 : 1);
  EdgeBoundary b;
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
  if (!map.colour.empty()) {
    const Vec3 own = garment.colour / garment.n, beyond = other.colour / other.n;
    b.contrast = std::min({(own - beyond).norm(),
                           nearest_colour(map, boundary, column, garment_above, beyond),
                           nearest_colour(map, boundary, column, !garment_above, own)});
  }
  b.valid = true;
  return b;
}

double evidence(const EdgeBoundary& b, const EdgeSearch& search, bool coloured) {
  if (!b.valid || b.garment_r > search.widest) return 0;
  if (b.drop) return kDropEvidence * b.filled;
  // Beyond a cloth's thickness evidence grows ever more slowly, but grows: its peak is the edge.
  double step = std::max(b.step / search.cloth_step, -1.0);
  if (step > 1) step = 1 + (step - 1) / (step + 1) * (kMostEvidence - 1);
  if (b.step > search.most_step) step = kSeenShare;  // a hand beside the edge, not cloth on skin
  if (!coloured) return step;
  return 0.5 * step + colour_evidence(b.contrast);
}

}  // namespace

double colour_evidence(double contrast) {
  return kMostEvidence * contrast / (contrast + kFullContrast);
}

EdgeEvidence edge_evidence(const LimbMap& map, const EdgeSearch& search) {
  EdgeEvidence out;
  out.low = std::max(1, static_cast<int>(std::ceil((search.s_low - map.s_low) / map.step)));
  const int high =
      std::min(map.rows - 1, static_cast<int>(std::floor((search.s_high - map.s_low) / map.step)));
  out.rows = std::max(0, high - out.low + 1), out.columns = map.columns;
  if (out.rows < 3) return out;
  const std::size_t cells =
      static_cast<std::size_t>(out.rows) * static_cast<std::size_t>(map.columns);
  out.boundary.resize(cells), out.score.resize(cells);
  for (int j = 0; j < map.columns; ++j) {
    for (int i = 0; i < out.rows; ++i) {
      const std::size_t k = out.index(i, j);
      out.boundary[k] = fit_boundary(map, out.low + i, j, search.garment_above);
      out.score[k] = evidence(out.boundary[k], search, !map.colour.empty());
      if (search.spread > 0 && !search.centre.empty()) {
        const double z = (map.s_low + (out.low + i) * map.step - search.centre[j]) / search.spread;
        out.score[k] -= 0.1 * z * z;
      }
    }
  }
  return out;
}

}  // namespace regarment
