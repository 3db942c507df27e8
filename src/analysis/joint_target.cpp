#include "analysis/joint_target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/point_tree.h"
#include "measure/edge_finder.h"

namespace regarment {
namespace {

constexpr double kCell = 0.008;       // m, scan is averaged over this
constexpr double kStepOver = 0.018;   // m between points of one piece
constexpr double kEven = 0.3;         // cosine between their normals
constexpr double kLeastPiece = 0.06;  // of all cloth: a smaller piece is something else
constexpr double kOneWay = 0.3;       // of the area: normals of a cell that cancel further are none

void average_cloth(const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth,
                   JointTarget& target) {
  using Key = std::array<std::int64_t, 4>;
  std::vector<std::pair<Key, std::size_t>> cells;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (!cloth[s] || samples.normals[s].squaredNorm() < 0.5) continue;
    const Vec3 c = (samples.positions[s] / kCell).array().floor();
    Eigen::Index axis = 0;
    samples.normals[s].cwiseAbs().maxCoeff(&axis);
    cells.push_back({{static_cast<std::int64_t>(c.x()), static_cast<std::int64_t>(c.y()),
                      static_cast<std::int64_t>(c.z()), 2 * axis + (samples.normals[s][axis] > 0)},
                     s});
  }
  std::sort(cells.begin(), cells.end());
  for (std::size_t i = 0; i < cells.size();) {
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
    double area = 0;
    const Key& key = cells[i].first;
    for (; i < cells.size() && cells[i].first == key; ++i) {
      const std::size_t s = cells[i].second;
      point += samples.areas[s] * samples.positions[s];
      normal += samples.areas[s] * samples.normals[s], area += samples.areas[s];
    }
    if (!(normal.norm() > kOneWay * area)) continue;
    target.points.push_back(point / area);
    target.normals.push_back(normal.normalized());
    target.areas.push_back(area);
  }
}

/// Leaves out small pieces that no even surface joins to the rest: legs seen under a hem.
void drop_small_pieces(JointTarget& target) {
  const std::size_t n = target.points.size();
  if (n == 0) return;
  const PointTree tree(target.points);
  std::vector<std::size_t> piece(n, n), todo;
  std::vector<double> area;
  std::vector<PointNeighbour> near;
  for (std::size_t first = 0; first < n; ++first) {
    if (piece[first] < n) continue;
    area.push_back(0);
    piece[first] = area.size() - 1;
    for (todo = {first}; !todo.empty();) {
      const std::size_t i = todo.back();
      todo.pop_back();
      area.back() += target.areas[i];
      tree.within(target.points[i], kStepOver, near);
      for (const PointNeighbour& other : near) {
        const std::size_t j = other.index;
        if (piece[j] < n || target.normals[i].dot(target.normals[j]) < kEven) continue;
        piece[j] = piece[i];
        todo.push_back(j);
      }
    }
  }
  const double least = kLeastPiece * std::accumulate(area.begin(), area.end(), 0.0);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (area[piece[i]] < least) continue;
    target.points[kept] = target.points[i], target.normals[kept] = target.normals[i];
    target.areas[kept++] = target.areas[i];
  }
  target.points.resize(kept), target.normals.resize(kept), target.areas.resize(kept);
}

}  // namespace

JointTarget joint_target(const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth,
                         const GarmentEdges& edges) {
  JointTarget target;
  average_cloth(samples, cloth, target);
  drop_small_pieces(target);
  for (const auto& [name, edge] : edges.edges) {
    if (edge.covered) continue;
    const LimbView& view = edges.limbs.at(edge.limb);
    target.edges[name] = {edge_points(edge.found, view.map, view.axis), edge.found.standard_error};
  }
  return target;
}

}  // namespace regarment
