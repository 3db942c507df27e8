#include "scan/body_sample.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace regarment {
namespace {

constexpr double kCellsAlong = 96;          // cells along the longest side
constexpr double kCoarsestCellsAlong = 30;  // where a sparse cloud is given up on
constexpr double kMargin = 0.12;            // of the longest side, kept around the robust extent
constexpr double kStray = 0.001;            // share of points that may lie outside at either end
constexpr double kConnected = 0.8;          // share of points the large pieces should hold
constexpr double kLarge = 0.03;             // of all filled cells: a person, or what stands beside
constexpr double kFilled = 4.0;       // samples a cell should hold on average, or it has holes
constexpr double kOnePlace = 1e-100;  // file units; arithmetic fails on less
constexpr double kMostSamples = 6e6;  // on triangles, so that absurd ones cannot take for ever

struct Extent {
  Vec3 low, high;
  double longest() const { return (high - low).maxCoeff(); }
};

Extent robust_extent(std::span<const Vec3> points) {
  const std::size_t n = points.size();
  const auto skip = static_cast<std::size_t>(kStray * static_cast<double>(n));
  std::vector<double> values(n);
  Extent extent;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < n; ++i) values[i] = points[i][axis];
    std::nth_element(values.begin(), values.begin() + skip, values.end());
    extent.low[axis] = values[skip];
    std::nth_element(values.begin(), values.begin() + (n - 1 - skip), values.end());
    extent.high[axis] = values[n - 1 - skip];
  }
  return extent;
}

/// The connected pieces of a grid.
struct Pieces {
  std::vector<int> of_cell;                      // -1 for empty ones
  std::vector<std::size_t> cells_of, points_of;  // per piece

  double points_in_large() const {
    const double cells = std::accumulate(cells_of.begin(), cells_of.end(), 0.0);
    double points = 0;
    for (std::size_t i = 0; i < cells_of.size(); ++i) {
      const bool large = static_cast<double>(cells_of[i]) > kLarge * cells;
      points += large ? static_cast<double>(points_of[i]) : 0.0;
    }
    return points;
  }
};

class Grid {
 public:
  Grid(const Extent& extent, double cell) : cell_(cell), centre_((extent.low + extent.high) / 2) {
    const double margin = kMargin * extent.longest();
    for (int axis = 0; axis < 3; ++axis) {
      const double reach = (extent.high[axis] - extent.low[axis]) / 2 + margin;
      half_[axis] = static_cast<int>(std::ceil(reach / cell)) + 1;
      size_[axis] = 2 * half_[axis] + 1;
    }
    sums_.assign(cells(), Vec3::Zero());
    counts_.assign(cells(), 0);
    points_.assign(cells(), 0);
  }

  std::size_t cells() const {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
           static_cast<std::size_t>(size_[2]);
  }

  void add(const Vec3& p, bool is_point) {
    const std::ptrdiff_t i = index(p);
    if (i < 0) return;
    sums_[i] += p - centre_;
    ++counts_[i];
    points_[i] += is_point ? 1 : 0;
  }

  /// Mean over the cells that hold any.
  double samples_per_cell() const {
    double samples = 0, cells = 0;
    for (const std::uint32_t count : counts_) {
      samples += count;
      cells += count > 0 ? 1 : 0;
    }
    return samples / std::max(cells, 1.0);
  }

  /// Neighbours touch by a face, edge or corner.
  Pieces pieces() const;

  BodySample sample(const Pieces& pieces, double longest) const;

 private:
  std::ptrdiff_t index(const Vec3& p) const {
    std::ptrdiff_t i = 0;
    for (int axis = 0; axis < 3; ++axis) {
      // nearbyint, not floor: a mirrored coordinate falls into the mirrored cell.
      const double at = std::nearbyint((p[axis] - centre_[axis]) / cell_);
      if (!(std::abs(at) < half_[axis])) return -1;  // the rim stays empty
      i = i * size_[axis] + static_cast<int>(at) + half_[axis];
    }
    return i;
  }

  template <typename Visit>
  void for_neighbours(std::ptrdiff_t i, Visit visit) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          visit(i + (std::ptrdiff_t{dx} * size_[1] + dy) * size_[2] + dz);
        }
      }
    }
  }

  double cell_;
  Vec3 centre_;
  std::array<int, 3> half_{}, size_{};
  std::vector<Vec3> sums_;             // relative to the centre
  std::vector<std::uint32_t> counts_;  // samples per cell
  std::vector<std::uint32_t> points_;  // points of the input per cell
};

Pieces Grid::pieces() const {
  Pieces pieces;
  pieces.of_cell.assign(cells(), -1);
  std::vector<std::ptrdiff_t> open;
  for (std::size_t start = 0; start < cells(); ++start) {
    if (counts_[start] == 0 || pieces.of_cell[start] >= 0) continue;
    const int number = static_cast<int>(pieces.points_of.size());
    pieces.cells_of.push_back(0);
    pieces.points_of.push_back(0);
    pieces.of_cell[start] = number;
    open.assign(1, static_cast<std::ptrdiff_t>(start));
    while (!open.empty()) {
      const std::ptrdiff_t at = open.back();
      open.pop_back();
      ++pieces.cells_of.back();
      pieces.points_of.back() += points_[at];
      for_neighbours(at, [&](std::ptrdiff_t next) {
        if (counts_[next] == 0 || pieces.of_cell[next] >= 0) return;
        pieces.of_cell[next] = number;
        open.push_back(next);
      });
    }
  }
  return pieces;
}

BodySample Grid::sample(const Pieces& pieces, double longest) const {
  const std::vector<int>& piece = pieces.of_cell;
  std::vector<SamplePiece> parts(pieces.cells_of.size());
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] < 0) continue;
    parts[piece[i]].points.push_back(centre_ + sums_[i] / counts_[i]);
    parts[piece[i]].samples += counts_[i];
  }
  const std::vector<Belongs> judged = judge_pieces(parts, cell_, longest);
  BodySample sample;
  sample.cell = cell_;
  sample.longest = longest;
  sample.centre = centre_;
  sample.half = half_;
  sample.belongs.assign(cells(), Belongs::Stray);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] >= 0) sample.belongs[i] = judged[piece[i]];
  }
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] < 0 || judged[piece[i]] != Belongs::Body) continue;
    sample.points.push_back(centre_ + sums_[i] / counts_[i]);
    for_neighbours(static_cast<std::ptrdiff_t>(i),
                   [&](std::ptrdiff_t next) { sample.belongs[next] = Belongs::Body; });
  }
  return sample;
}

/// Steps along each side so that samples of a triangle are at most `spacing` apart.
int steps_for(const Vec3& a, const Vec3& b, const Vec3& c, double spacing) {
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return static_cast<int>(std::min(std::ceil(longest / spacing), 1000.0));
}

void add_triangles(std::span<const Vec3> points, std::span<const Triangle> triangles,
                   double spacing, Grid& grid) {
  double planned = 0;
  for (const auto& [i, j, k] : triangles) {
    const double steps = steps_for(points[i], points[j], points[k], spacing);
    if (steps > 1) planned += steps * steps / 2;
  }
  spacing *= std::sqrt(std::max(1.0, planned / kMostSamples));
  for (const auto& [i, j, k] : triangles) {
    const Vec3 &a = points[i], &b = points[j], &c = points[k];
    const int steps = steps_for(a, b, c, spacing);
    if (steps <= 1) continue;  // its corners are near enough
    const Vec3 along = (b - a) / steps, across = (c - a) / steps;
    for (int u = 0; u <= steps; ++u) {
      for (int v = 0; u + v <= steps; ++v) grid.add(a + u * along + v * across, false);
    }
  }
}

}  // namespace

Belongs BodySample::at(const Vec3& p) const {
  std::size_t i = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double at = std::nearbyint((p[axis] - centre[axis]) / cell);
    if (!(std::abs(at) <= half[axis])) return Belongs::Stray;
    i = i * static_cast<std::size_t>(2 * half[axis] + 1) +
        static_cast<std::size_t>(static_cast<int>(at) + half[axis]);
  }
  return belongs[i];
}

BodySample sample_body(std::span<const Vec3> points, std::span<const Triangle> triangles) {
  const Extent extent = robust_extent(points);
  const double longest = extent.longest();
  if (!(longest > kOnePlace) || !std::isfinite(longest)) {
    BodySample nothing;
    nothing.centre = points[0];
    nothing.cell = 1.0;
    nothing.belongs.assign(1, Belongs::Body);
    return nothing;
  }
  for (double cell = longest / kCellsAlong;; cell *= 1.4) {
    Grid grid(extent, cell);
    for (const Vec3& p : points) grid.add(p, true);
    add_triangles(points, triangles, 0.7 * cell, grid);
    const Pieces pieces = grid.pieces();
    const bool connected =
        pieces.points_in_large() > kConnected * static_cast<double>(points.size());
    if ((connected && grid.samples_per_cell() > kFilled) || cell * kCoarsestCellsAlong > longest) {
      return grid.sample(pieces, longest);
    }
  }
}

}  // namespace regarment
