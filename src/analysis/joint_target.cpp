#include "analysis/joint_target.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "measure/edge_finder.h"

namespace regarment {
namespace {

constexpr double kCell = 0.008;  // m, scan is averaged over this
constexpr double kOneWay = 0.3;  // of the area: normals of a cell that cancel further are none

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

}  // namespace

JointTarget joint_target(const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth,
                         const GarmentEdges& edges) {
  JointTarget target;
  average_cloth(samples, cloth, target);
  for (const auto& [name, edge] : edges.edges) {
    if (edge.covered) continue;
    const LimbView& view = edges.limbs.at(edge.limb);
    target.edges[name] = {edge_points(edge.found, view.map, view.axis), edge.found.standard_error};
  }
  return target;
}

}  // namespace regarment
