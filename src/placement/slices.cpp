#include "placement/slices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace regarment {
namespace {

struct Cell {
  std::int64_t x, z;
  int sample;
  bool operator<(const Cell& o) const {
    return x != o.x ? x < o.x : z != o.z ? z < o.z : sample < o.sample;
  }
};

class Union {
 public:
  explicit Union(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

std::vector<SliceCluster> clusters_of(const SurfaceSamples& samples,
                                      const std::vector<int>& members, double cell) {
  std::vector<Cell> cells;
  cells.reserve(members.size());
  for (int s : members) {
    const Vec3& p = samples.positions[s];
    cells.push_back({static_cast<std::int64_t>(std::floor(p.x() / cell)),
                     static_cast<std::int64_t>(std::floor(p.z() / cell)), s});
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::size_t> first;  // first entry of each distinct cell
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (i == 0 || cells[i].x != cells[i - 1].x || cells[i].z != cells[i - 1].z) first.push_back(i);
  const auto find_cell = [&](std::int64_t x, std::int64_t z) {
    const auto it = std::lower_bound(first.begin(), first.end(), Cell{x, z, -1},
                                     [&](std::size_t i, const Cell& c) { return cells[i] < c; });
    if (it == first.end() || cells[*it].x != x || cells[*it].z != z) return -1;
    return static_cast<int>(it - first.begin());
  };
  Union pieces(first.size());
  constexpr std::int64_t kNeighbours[4][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  for (std::size_t k = 0; k < first.size(); ++k) {
    for (const auto& d : kNeighbours) {
      const int other = find_cell(cells[first[k]].x + d[0], cells[first[k]].z + d[1]);
      if (other >= 0) pieces.join(static_cast<int>(k), other);
    }
  }
  std::vector<int> cluster_of(first.size(), -1);
  std::vector<SliceCluster> out;
  for (std::size_t k = 0; k < first.size(); ++k) {
    int& id = cluster_of[pieces.find(static_cast<int>(k))];
    if (id < 0) {
      id = static_cast<int>(out.size());
      out.push_back({1e9, -1e9, 1e9, -1e9, 0, {}});
    }
    SliceCluster& c = out[id];
    const std::size_t end = k + 1 < first.size() ? first[k + 1] : cells.size();
    for (std::size_t i = first[k]; i < end; ++i) {
      const Vec3& p = samples.positions[cells[i].sample];
      c.x_min = std::min(c.x_min, p.x()), c.x_max = std::max(c.x_max, p.x());
      c.z_min = std::min(c.z_min, p.z()), c.z_max = std::max(c.z_max, p.z());
      c.area += samples.areas[cells[i].sample];
      c.samples.push_back(cells[i].sample);
    }
  }
  for (SliceCluster& c : out) std::sort(c.samples.begin(), c.samples.end());
  std::stable_sort(out.begin(), out.end(),
                   [](const SliceCluster& a, const SliceCluster& b) { return a.area > b.area; });
  return out;
}

}  // namespace

Slices slice_body(const SurfaceSamples& samples, double height, double cell) {
  double top = 0;
  for (const Vec3& p : samples.positions) top = std::max(top, p.y());
  std::vector<std::vector<int>> members(static_cast<std::size_t>(top / height) + 1);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const double level = std::max(0.0, std::floor(samples.positions[s].y() / height));
    members[static_cast<std::size_t>(level)].push_back(static_cast<int>(s));
  }
  Slices slices;
  slices.height = height;
  for (const std::vector<int>& level : members)
    slices.levels.push_back(clusters_of(samples, level, cell));
  return slices;
}

}  // namespace regarment
