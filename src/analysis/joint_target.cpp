#include "analysis/joint_target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/parallel.h"
#include "geometry/point_tree.h"
#include "measure/edge_finder.h"

namespace regarment {
namespace {

constexpr double kCell = 0.008;       // m, scan is averaged over this
constexpr double kStepOver = 0.018;   // m between points of one piece
constexpr double kEven = 0.3;         // cosine between their normals
constexpr double kLeastPiece = 0.06;  // of all cloth: a smaller piece may be a leg
constexpr double kGoesOn = 0.08;      // of a piece, where the person goes on from it: a leg
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

/// Does what lies outside of the garment go on evenly from a point on it?
bool goes_on(const PointTree& outside, const std::vector<Vec3>& outside_normals, const Vec3& point,
             const Vec3& normal, std::vector<PointNeighbour>& near) {
  outside.within(point, kStepOver, near);
  return std::any_of(near.begin(), near.end(), [&](const PointNeighbour& other) {
    return outside_normals[other.index].dot(normal) >= kEven;
  });
}

/// Leaves out legs seen under a hem: small pieces that no even surface joins to the rest, and that
/// go on in `person`, which is not the garment's. The inner sheets of folds end at the hem.
void drop_legs(const JointTarget& person, JointTarget& target) {
  const std::size_t n = target.points.size();
  if (n == 0) return;
  const PointTree tree(target.points);
  std::vector<std::size_t> piece(n, n), todo;
  std::vector<double> area, beyond;  // per piece, m^2: all of it, and where the person goes on
  std::vector<PointNeighbour> near;
  const PointTree outside(person.points);
  for (std::size_t first = 0; first < n; ++first) {
    if (piece[first] < n) continue;
    area.push_back(0), beyond.push_back(0);
    piece[first] = area.size() - 1;
    for (todo = {first}; !todo.empty();) {
      const std::size_t i = todo.back();
      todo.pop_back();
      area.back() += target.areas[i];
      if (goes_on(outside, person.normals, target.points[i], target.normals[i], near))
        beyond.back() += target.areas[i];
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
    if (area[piece[i]] < least && beyond[piece[i]] > kGoesOn * area[piece[i]]) continue;
    target.points[kept] = target.points[i], target.normals[kept] = target.normals[i];
    target.areas[kept++] = target.areas[i];
  }
  target.points.resize(kept), target.normals.resize(kept), target.areas.resize(kept);
}

}  // namespace

JointTarget joint_target(const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth,
                         const GarmentEdges& edges,
                         const std::map<std::string, HiddenEdge>& hidden) {
  JointTarget target, person;
  std::vector<std::uint8_t> other(cloth.size());
  for (std::size_t s = 0; s < cloth.size(); ++s) other[s] = cloth[s] == 0 ? 1 : 0;
  run_together({[&] { average_cloth(samples, cloth, target); },
                [&] { average_cloth(samples, other, person); }});
  drop_legs(person, target);
  for (const auto& [name, edge] : edges.edges) {
    const LimbView& view = edges.limbs.at(edge.limb);
    JointTarget::Edge seen{edge_curve(edge, view), edge.found.standard_error};
    if (edge.covered) {
      const auto guess = hidden.find(name);
      if (guess == hidden.end()) continue;
      seen.standard_error = guess->second.standard_deviation, seen.as_one = true;
      for (Vec3& p : seen.curve) p.y() += (edge.garment_above ? -1 : 1) * guess->second.beyond;
    }
    target.edges[name] = std::move(seen);
  }
  return target;
}

}  // namespace regarment
