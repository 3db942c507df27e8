#include "fill/fill_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/point_tree.h"
#include "geometry/surface_samples.h"

namespace regarment {
namespace {

// Spacings: a cloud's own gaps between points are smaller than this, and the cloth lies about one
// spacing or the noise off its points.
constexpr double kGap = 3.0;
// A group of points is a hole when some lie this far from the cloud (spacings, and m) and as far
// from the garment's open edges as edges may be missed by.
constexpr double kDeepGap = 4.0;
constexpr double kDeep = 0.012;
constexpr double kOffEdge = 0.03;  // m
constexpr double kTogether = 2.0;  // spacings between neighbours of one group

double distance_to(const PointTree& tree, const Vec3& p) {
  std::array<PointNeighbour, 1> found;
  return tree.nearest(p, found) == 0 ? std::numeric_limits<double>::infinity()
                                     : std::sqrt(found[0].squared_distance);
}

double distance_to_edges(const std::vector<EdgeLoop>& edges, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const EdgeLoop& edge : edges) least = std::min(least, edge.nearest(p).distance);
  return least;
}

/// Numbers of groups of points that hang together.
std::vector<std::size_t> groups_of(const std::vector<Vec3>& points, double reach) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> group(points.size(), kNone);
  const PointTree tree(points);
  std::vector<PointNeighbour> near;
  std::vector<std::size_t> open;
  std::size_t next = 0;
  for (std::size_t first = 0; first < points.size(); ++first) {
    if (group[first] != kNone) continue;
    group[first] = next;
    open.assign(1, first);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      tree.within(points[i], reach, near);
      for (const PointNeighbour& n : near)
        if (group[n.index] == kNone) group[n.index] = next, open.push_back(n.index);
    }
    ++next;
  }
  return group;
}

}  // namespace

std::vector<Vec3> fill_cloud(const std::vector<Vec3>& cloud, const Mesh& cloth,
                             const std::vector<EdgeLoop>& edges, double spacing) {
  if (!(spacing > 0)) throw InvalidInput("fill_cloud: spacing must be > 0");
  if (cloud.empty()) return {};
  const PointTree tree(cloud);
  const SurfaceSamples samples = sample_surface(cloth, spacing);
  std::vector<Vec3> bare;
  std::vector<double> distance, area;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double d = distance_to(tree, samples.positions[i]);
    if (!(d > kGap * spacing)) continue;
    bare.push_back(samples.positions[i]);
    distance.push_back(d);
    area.push_back(samples.areas[i]);
  }
  if (bare.empty()) return {};
  const std::vector<std::size_t> group = groups_of(bare, kTogether * spacing);
  std::vector<std::uint8_t> hole(bare.size(), 0);  // per group
  const double deep = std::max(kDeep, kDeepGap * spacing);
  for (std::size_t i = 0; i < bare.size(); ++i)
    if (distance[i] >= deep && distance_to_edges(edges, bare[i]) >= kOffEdge) hole[group[i]] = 1;
  // Samples stand closer than the cloud's points: one for each point's share of the surface.
  std::vector<Vec3> out;
  double owed = 0;
  for (std::size_t i = 0; i < bare.size(); ++i) {
    if (hole[group[i]] == 0) continue;
    owed += area[i] / (spacing * spacing);
    if (owed < 1) continue;
    owed -= std::floor(owed);
    out.push_back(bare[i]);
  }
  return out;
}

}  // namespace regarment
