#include "synthetic/reconstruct_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/error.h"

namespace regarment {
namespace {

// Cells that a point is heard along its normal and across it. Across it is less, or a sheet would
// go on beyond its edge.
constexpr double kReach = 2, kReachAcross = 1.25;
constexpr int kMargin = 6;  // cells around the points
constexpr double kMostNodes = 1 << 24;
constexpr float kTrust = 4;    // pull of a point at a node, against that of a neighbour
constexpr int kSmallest = 12;  // nodes along the shortest side of the coarsest grid, at most
constexpr int kSweeps = 24;    // on coarse grids
constexpr int kFinestSweeps = 8;

// A grid with what the points say at its nodes.
struct Level {
  DistanceField field;
  std::vector<float> weight, target;  // target in m, where weight > 0

  void sweep(std::span<const std::uint32_t> nodes) {
    const std::size_t row = field.size[0], slice = row * field.size[1];
    float* f = field.value.data();
    for (const std::uint32_t i : nodes) {
      const float around =
          f[i - 1] + f[i + 1] + f[i - row] + f[i + row] + f[i - slice] + f[i + slice];
      f[i] = (around + weight[i] * target[i]) / (6 + weight[i]);
    }
  }
};

// Nodes off the border in two lists like a chessboard's, so that a sweep's order does not matter.
struct Chessboard {
  std::array<std::vector<std::uint32_t>, 2> squares;

  template <class Chosen>
  Chessboard(const DistanceField& field, const Chosen& chosen) {
    for (int z = 1; z + 1 < field.size[2]; ++z)
      for (int y = 1; y + 1 < field.size[1]; ++y)
        for (int x = 1; x + 1 < field.size[0]; ++x)
          if (chosen(x, y, z))
            squares[(x + y + z) % 2].push_back(static_cast<std::uint32_t>(field.index(x, y, z)));
  }

  void relax(Level& level, int sweeps) const {
    for (int i = 0; i < sweeps; ++i)
      for (const auto& list : squares) level.sweep(list);
  }
};

DistanceField grid_around(std::span<const Vec3> points, double cell) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& p : points) {
    if (!p.allFinite()) throw InvalidInput("a point to be joined to a surface is nowhere");
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto nodes = [&] { return ((high - low) / cell + Vec3::Constant(2 * kMargin + 1)).prod(); };
  while (!(nodes() <= kMostNodes)) cell *= 1.05;
  DistanceField field;
  field.cell = cell;
  field.origin = low - Vec3::Constant(kMargin * cell);
  for (int i = 0; i < 3; ++i)
    field.size[i] = static_cast<int>(std::ceil((high[i] - low[i]) / cell)) + 2 * kMargin;
  return field;
}

// What one point says: its tangent plane's distance, the more the nearer a node.
void add_point(const Vec3& point, const Vec3& normal, Level& level) {
  const DistanceField& field = level.field;
  const Vec3 at = (point - field.origin) / field.cell;
  std::array<int, 3> first{}, last{};
  for (int i = 0; i < 3; ++i) {
    first[i] = static_cast<int>(std::ceil(at[i] - kReach));
    last[i] = static_cast<int>(std::floor(at[i] + kReach));
  }
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int x = first[0]; x <= last[0]; ++x) {
        const Vec3 off = Vec3(x, y, z) - at;
        const double along = off.dot(normal), across = off.squaredNorm() - along * along;
        const double near =
            1 - along * along / (kReach * kReach) - across / (kReachAcross * kReachAcross);
        if (near <= 0) continue;
        const std::size_t i = field.index(x, y, z);
        const double weight = near * near;
        level.weight[i] += static_cast<float>(weight);
        level.target[i] += static_cast<float>(weight * field.cell * along);
      }
}

Level finest(std::span<const Vec3> points, std::span<const Vec3> normals, double cell) {
  Level level{grid_around(points, cell), {}, {}};
  level.weight.assign(level.field.nodes(), 0);
  level.target.assign(level.field.nodes(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) add_point(points[i], normals[i], level);
  for (std::size_t i = 0; i < level.weight.size(); ++i) {
    if (level.weight[i] == 0) continue;
    level.target[i] /= level.weight[i];
    level.weight[i] *= kTrust;
  }
  return level;
}

// Two by two by two nodes become one.
Level coarser(const Level& fine) {
  Level level;
  const DistanceField& from = fine.field;
  level.field.cell = 2 * from.cell;
  for (int i = 0; i < 3; ++i) level.field.size[i] = (from.size[i] + 1) / 2;
  level.weight.assign(level.field.nodes(), 0);
  level.target.assign(level.field.nodes(), 0);
  for (int z = 0; z < from.size[2]; ++z)
    for (int y = 0; y < from.size[1]; ++y)
      for (int x = 0; x < from.size[0]; ++x) {
        const std::size_t i = from.index(x, y, z), j = level.field.index(x / 2, y / 2, z / 2);
        level.weight[j] += fine.weight[i];
        level.target[j] += fine.weight[i] * fine.target[i];
      }
  for (std::size_t j = 0; j < level.weight.size(); ++j)
    if (level.weight[j] > 0) level.target[j] /= level.weight[j];
  return level;
}

void take_over(const Level& coarse, Level& fine) {
  fine.field.value.resize(fine.field.nodes());
  std::size_t i = 0;
  for (int z = 0; z < fine.field.size[2]; ++z)
    for (int y = 0; y < fine.field.size[1]; ++y)
      for (int x = 0; x < fine.field.size[0]; ++x)
        fine.field.value[i++] = coarse.field.value[coarse.field.index(x / 2, y / 2, z / 2)];
}

// Coarse nodes with points, or with a neighbour on the other side of the surface.
std::vector<std::uint8_t> near_surface(const Level& level) {
  const DistanceField& field = level.field;
  std::vector<std::uint8_t> near(field.nodes(), 0);
  const Chessboard all(field, [](int, int, int) { return true; });
  const std::size_t row = field.size[0], slice = row * field.size[1];
  for (const auto& list : all.squares)
    for (const std::uint32_t i : list) {
      const bool outside = field.value[i] > 0;
      bool chosen = level.weight[i] > 0;
      for (const std::size_t step : {std::size_t{1}, row, slice})
        chosen = chosen || (field.value[i - step] > 0) != outside ||
                 (field.value[i + step] > 0) != outside;
      near[i] = chosen ? 1 : 0;
    }
  return near;
}

}  // namespace

DistanceField distance_field(std::span<const Vec3> points, std::span<const Vec3> normals,
                             double cell) {
  if (points.empty() || points.size() != normals.size())
    throw InvalidInput("a surface needs points, and a normal for each");
  std::vector<Level> levels{finest(points, normals, cell)};
  const auto shortest = [&] {
    const auto& size = levels.back().field.size;
    return *std::min_element(size.begin(), size.end());
  };
  while (levels.size() < 2 || shortest() > kSmallest) levels.push_back(coarser(levels.back()));
  const auto outside = static_cast<float>(kReach * levels.front().field.cell);
  levels.back().field.value.assign(levels.back().field.nodes(), outside);
  for (std::size_t i = levels.size() - 1; i > 0; --i) {
    if (i + 1 < levels.size()) take_over(levels[i + 1], levels[i]);
    Chessboard(levels[i].field, [](int, int, int) { return true; }).relax(levels[i], kSweeps);
  }
  Level& fine = levels[0];
  take_over(levels[1], fine);
  const std::vector<std::uint8_t> near = near_surface(levels[1]);
  const DistanceField& coarse = levels[1].field;
  Chessboard(fine.field, [&](int x, int y, int z) {
    return near[coarse.index(x / 2, y / 2, z / 2)] != 0;
  }).relax(fine, kFinestSweeps);
  return std::move(fine.field);
}

}  // namespace regarment
