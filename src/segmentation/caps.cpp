#include "segmentation/caps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace regarment {
namespace {

constexpr double kAlong = 0.64;    // cosine of 50 degrees between a cap's normal and the limb
constexpr double kBeside = 0.03;   // m from the edge along the limb
constexpr double kInside = 0.004;  // m within the loop: the hem itself is cloth

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

std::vector<std::uint8_t> find_caps(const Scan& scan, const GarmentEdges& edges) {
  const Mesh& mesh = scan.mesh;
  std::vector<std::uint8_t> cap(mesh.triangles.size(), 0);
  for (const auto& [name, edge] : edges.edges) {
    if (edge.limb == "neck" || (edge.limb == "torso" && !edge.garment_above)) continue;
    const LimbView& view = edges.limbs.at(edge.limb);
    const auto [low, high] = std::minmax_element(edge.found.s.begin(), edge.found.s.end());
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      const Triangle& t = mesh.triangles[f];
      const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
      const LimbPoint at = view.axis.locate((a + b + c) / 3);
      if (at.s < *low - kBeside || at.s > *high + kBeside) continue;
      const int column =
          std::clamp(static_cast<int>((at.phi / (2 * std::numbers::pi) + 0.5) * view.map.columns),
                     0, view.map.columns - 1);
      if (std::abs(at.s - edge.found.s[column]) > kBeside || at.r > edge.found.r[column] - kInside)
        continue;
      const Vec3 normal = (b - a).cross(c - a);
      // A cap faces out of the garment: against the way from the edge to the cloth.
      const double facing = normal.dot(view.axis.tangent(at.s)) * (edge.garment_above ? -1 : 1);
      if (facing > kAlong * normal.norm()) cap[f] = 1;
    }
  }
  return cap;
}

int count_caps(const Scan& scan, const std::vector<std::uint8_t>& cap, double least_area) {
  std::vector<int> parent(scan.mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t f = 0; f < cap.size(); ++f) {
    if (!cap[f]) continue;
    const Triangle& t = scan.mesh.triangles[f];
    for (int k = 1; k < 3; ++k)
      parent[root_of(parent, static_cast<int>(t[k]))] = root_of(parent, static_cast<int>(t[0]));
  }
  std::vector<double> area(parent.size(), 0.0);
  for (std::size_t f = 0; f < cap.size(); ++f) {
    if (!cap[f]) continue;
    const Triangle& t = scan.mesh.triangles[f];
    const Vec3& a = scan.mesh.positions[t[0]];
    area[root_of(parent, static_cast<int>(t[0]))] +=
        0.5 * (scan.mesh.positions[t[1]] - a).cross(scan.mesh.positions[t[2]] - a).norm();
  }
  return static_cast<int>(
      std::count_if(area.begin(), area.end(), [&](double x) { return x >= least_area; }));
}

}  // namespace regarment
