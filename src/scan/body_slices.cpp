#include "scan/body_slices.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "scan/robust.h"

namespace regarment {
namespace {

constexpr double kStray = 0.001;      // share of points beyond either end of the height
constexpr std::size_t kSpeck = 4;     // pieces of fewer cells are noise
constexpr double kSmallPiece = 0.08;  // of the slice's largest piece

/// Extents of points along the principal axes of their spread, longer first; `share` is left out at
/// each end.
std::pair<double, double> principal_extents(const std::vector<Vec2>& points, double share) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p;
  mean /= static_cast<double>(std::max<std::size_t>(points.size(), 1));
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& p : points) spread += (p - mean) * (p - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(spread);
  std::array<double, 2> extents{};
  std::vector<double> along(points.size());
  for (int axis = 0; axis < 2; ++axis) {
    const Vec2 direction = solver.eigenvectors().col(axis);
    std::transform(points.begin(), points.end(), along.begin(),
                   [&](const Vec2& p) { return direction.dot(p - mean); });
    extents[axis] = points.empty() ? 0 : quantile(along, 1 - share) - quantile(along, share);
  }
  return std::minmax(extents[1], extents[0], std::greater<>());
}

/// A square grid over the plane across the direction that remembers which piece a cell belongs to.
class PlaneGrid {
 public:
  PlaneGrid(const std::vector<Vec2>& points, double cell) : cell_(cell) {
    Vec2 low = points[0], high = low;
    for (const Vec2& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    origin_ = low;
    columns_ = static_cast<int>((high.x() - low.x()) / cell) + 4;
    rows_ = static_cast<int>((high.y() - low.y()) / cell) + 4;
    owner_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                  SlicePiece::kNone);
  }

  int cell_of(const Vec2& p) const {
    const int column = static_cast<int>(std::nearbyint((p.x() - origin_.x()) / cell_)) + 1;
    const int row = static_cast<int>(std::nearbyint((p.y() - origin_.y()) / cell_)) + 1;
    return row * columns_ + column;
  }
  int& owner(int cell) { return owner_[cell]; }

  template <typename Visit>
  void for_neighbourhood(int cell, Visit visit) const {
    for (int row = -1; row <= 1; ++row) {
      for (int column = -1; column <= 1; ++column) visit(cell + row * columns_ + column);
    }
  }

 private:
  double cell_;
  Vec2 origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<int> owner_;
};

struct RawPiece {
  std::vector<int> cells;  // grid cells
  std::vector<Vec2> points;
};

/// The connected pieces of one slice, largest first, specks left out. Leaves `grid` empty.
std::vector<RawPiece> split(const std::vector<Vec2>& points, PlaneGrid& grid) {
  constexpr int kUnseen = -2;
  std::vector<int> cells;
  for (const Vec2& p : points) {
    const int cell = grid.cell_of(p);
    if (grid.owner(cell) == kUnseen) continue;
    grid.owner(cell) = kUnseen;
    cells.push_back(cell);
  }
  std::vector<RawPiece> pieces;
  std::vector<int> open;
  for (const int start : cells) {
    if (grid.owner(start) != kUnseen) continue;
    const int number = static_cast<int>(pieces.size());
    pieces.emplace_back();
    grid.owner(start) = number;
    open.assign(1, start);
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      pieces.back().cells.push_back(at);
      grid.for_neighbourhood(at, [&](int next) {
        if (grid.owner(next) != kUnseen) return;
        grid.owner(next) = number;
        open.push_back(next);
      });
    }
  }
  for (const Vec2& p : points) pieces[grid.owner(grid.cell_of(p))].points.push_back(p);
  for (const int cell : cells) grid.owner(cell) = SlicePiece::kNone;
  std::stable_sort(pieces.begin(), pieces.end(), [](const RawPiece& a, const RawPiece& b) {
    return a.points.size() > b.points.size();
  });
  std::erase_if(pieces, [most = pieces.empty() ? 0 : pieces[0].points.size()](const RawPiece& p) {
    return p.points.size() < kSpeck ||
           static_cast<double>(p.points.size()) < kSmallPiece * static_cast<double>(most);
  });
  return pieces;
}

/// Tells each piece of the upper slice which piece of the lower one carries it, and which lower
/// ones carry nothing.
void link(const std::vector<RawPiece>& upper_raw, std::vector<SlicePiece>& upper,
          const std::vector<RawPiece>& lower_raw, std::vector<SlicePiece>& lower, PlaneGrid& grid) {
  for (std::size_t piece = 0; piece < lower_raw.size(); ++piece) {
    for (const int cell : lower_raw[piece].cells) grid.owner(cell) = static_cast<int>(piece);
  }
  for (std::size_t piece = 0; piece < upper_raw.size(); ++piece) {
    std::vector<int> touches(lower.size(), 0);
    for (const int cell : upper_raw[piece].cells) {
      grid.for_neighbourhood(cell, [&](int near) {
        if (grid.owner(near) >= 0) ++touches[grid.owner(near)];
      });
    }
    const auto most = std::max_element(touches.begin(), touches.end());
    if (most != touches.end() && *most > 0) {
      upper[piece].below = static_cast<int>(most - touches.begin());
    }
    for (std::size_t i = 0; i < lower.size(); ++i) {
      if (touches[i] > 0) lower[i].tip = false;
    }
  }
  for (const RawPiece& piece : lower_raw) {
    for (const int cell : piece.cells) grid.owner(cell) = SlicePiece::kNone;
  }
}

SlicePiece describe(const RawPiece& raw) {
  SlicePiece piece;
  piece.cells = raw.points.size();
  for (const Vec2& p : raw.points) piece.centre += p;
  piece.centre /= static_cast<double>(raw.points.size());
  std::tie(piece.width, piece.depth) = principal_extents(raw.points, 0.0);
  return piece;
}

}  // namespace

BodySlices slice_body(std::span<const Vec3> points, double cell, const Vec3& up) {
  BodySlices slices;
  slices.levels.resize(BodySlices::kLevels);
  if (points.size() < 2) return slices;
  const Vec3 e = up.unitOrthogonal(), f = up.cross(e);
  slices.t.resize(points.size());
  slices.across.resize(points.size());
  std::transform(points.begin(), points.end(), slices.t.begin(),
                 [&](const Vec3& p) { return up.dot(p); });
  slices.low = quantile(slices.t, kStray);
  slices.height = quantile(slices.t, 1 - kStray) - slices.low;
  if (!(slices.height > 0)) return slices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    slices.t[i] = (slices.t[i] - slices.low) / slices.height;
    slices.across[i] = Vec2(e.dot(points[i]), f.dot(points[i])) / slices.height;
  }
  const Vec2 middle(quantile_of(slices.across, 0.5, [](const Vec2& p) { return p.x(); }),
                    quantile_of(slices.across, 0.5, [](const Vec2& p) { return p.y(); }));
  for (Vec2& p : slices.across) p -= middle;
  std::tie(slices.width, slices.depth) = principal_extents(slices.across, 0.005);

  std::vector<std::vector<Vec2>> in_level(BodySlices::kLevels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int level = static_cast<int>(std::floor(slices.t[i] * BodySlices::kLevels));
    if (level >= 0 && level < BodySlices::kLevels) in_level[level].push_back(slices.across[i]);
  }
  PlaneGrid grid(slices.across, 1.5 * cell / slices.height);
  std::vector<RawPiece> upper;
  for (int level = BodySlices::kLevels - 1; level >= 0; --level) {
    std::vector<RawPiece> here = split(in_level[level], grid);
    for (const RawPiece& raw : here) slices.levels[level].push_back(describe(raw));
    if (level + 1 < BodySlices::kLevels) {
      link(upper, slices.levels[level + 1], here, slices.levels[level], grid);
    }
    upper = std::move(here);
  }
  return slices;
}

}  // namespace regarment
