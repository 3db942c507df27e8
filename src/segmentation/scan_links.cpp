#include "segmentation/scan_links.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "geometry/parallel.h"
#include "geometry/point_tree.h"

namespace regarment {
namespace {

constexpr std::size_t kNearest = 6;
constexpr std::size_t kGrain = 2048;
constexpr double kReach = 4;         // neighbours of a cloud's point lie within this many spacings
constexpr double kLeastShare = 0.1;  // of the cost that is left at a sharp crease
constexpr double kCrease = 0.35;     // sine of the turn that makes a crease

bool is_outlier(const Scan& scan, std::uint32_t v) {
  return !scan.outlier.empty() && scan.outlier[v] != 0;
}

/// How smooth the surface is between two vertices, kLeastShare..1.
double smoothness(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  const Vec3 &n = mesh.normals[a], &m = mesh.normals[b];
  const Vec3 way = mesh.positions[b] - mesh.positions[a];
  const double length = way.norm();
  const double turn = 1 - std::min(1.0, n.dot(m));  // half the squared sine of a small angle
  const double rise = length > 0 ? 0.5 * (n + m).dot(way) / length : 0;
  const double crease = 2 * turn + rise * rise;
  return kLeastShare + (1 - kLeastShare) * std::exp(-crease / (2 * kCrease * kCrease));
}

std::vector<CutLink> mesh_links(const Scan& scan, std::span<const std::uint8_t> wanted) {
  std::vector<CutLink> out;
  for (const Triangle& t : scan.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (!(wanted[a] || wanted[b]) || is_outlier(scan, a) || is_outlier(scan, b)) continue;
      out.push_back({a, b, static_cast<float>(0.5 * smoothness(scan.mesh, a, b))});
    }
  return out;
}

std::vector<CutLink> cloud_links(const Scan& scan, std::span<const std::uint8_t> wanted) {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> vertex;
  for (std::uint32_t v = 0; v < wanted.size(); ++v)
    if (!is_outlier(scan, v)) points.push_back(scan.mesh.positions[v]), vertex.push_back(v);
  const PointTree tree(points);
  const std::span<const std::uint32_t> order = tree.order();
  std::vector<CutLink> all(kNearest * points.size());
  const double reach = scan.facts.spacing > 0 ? kReach * scan.facts.spacing
                                              : std::numeric_limits<double>::infinity();
  parallel_for(order.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<PointNeighbour, kNearest + 1> near;  // the point itself is among them
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t a = vertex[order[i]];
      if (!wanted[a]) continue;
      const std::size_t count = tree.nearest(scan.mesh.positions[a], near, reach);
      std::size_t slot = kNearest * i;
      for (std::size_t k = 0; k < count && slot < kNearest * (i + 1); ++k) {
        const std::uint32_t b = vertex[near[k].index];
        if (b != a) all[slot++] = {a, b, static_cast<float>(0.5 * smoothness(scan.mesh, a, b))};
      }
    }
  });
  std::erase_if(all, [](const CutLink& link) { return link.a == link.b; });
  return all;
}

}  // namespace

std::vector<CutLink> scan_links(const Scan& scan, std::span<const std::uint8_t> wanted) {
  const std::size_t n = scan.mesh.positions.size();
  if (wanted.size() != n || scan.mesh.normals.size() != n)
    throw InvalidInput("scan_links: one mark and one normal per scan vertex");
  return scan.mesh.is_cloud() ? cloud_links(scan, wanted) : mesh_links(scan, wanted);
}

}  // namespace regarment
