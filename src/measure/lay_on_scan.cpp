#include "measure/lay_on_scan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "garment/particles.h"
#include "garment/springs.h"
#include "garment/worn_normals.h"
#include "geometry/closed_curve.h"
#include "geometry/parallel.h"

namespace regarment {
namespace {

constexpr int kCandidates = 6;    // nearest samples looked at for one of similar normal
constexpr double kSimilar = 0.3;  // cosine between normals (paper, sec. 3.4)
constexpr int kSweeps = 3;        // of straightening per round
constexpr double kSpringShare =
    0.35;  // of a spring's error taken away per sweep when it is too long
constexpr double kSlackShare = 0.05;  // the same when it is too short: cloth may fold
constexpr double kPull = 0.6;         // share of the way to the scan per round
constexpr double kEdgePull = 0.5;     // share of the way to an edge's curve per round
constexpr double kThinning = 0.008;   // m, one sample of the scan is kept per cell of this size

struct Cloth {
  std::vector<Vec3> positions, normals;
};

/// The samples on the garment, thinned so that the search stays quick.
Cloth cloth_samples(const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth) {
  std::vector<std::pair<std::array<std::int64_t, 3>, std::size_t>> cells;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (!cloth[s]) continue;
    const Vec3 c = (samples.positions[s] / kThinning).array().floor();
    cells.push_back({{static_cast<std::int64_t>(c.x()), static_cast<std::int64_t>(c.y()),
                      static_cast<std::int64_t>(c.z())},
                     s});
  }
  std::sort(cells.begin(), cells.end());
  Cloth out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0 && cells[i].first == cells[i - 1].first) continue;
    out.positions.push_back(samples.positions[cells[i].second]);
    out.normals.push_back(samples.normals[cells[i].second]);
  }
  return out;
}

void pull_to_scan(const PointTree& tree, const Cloth& cloth, const std::vector<Vec3>& normals,
                  double reach, std::vector<Vec3>& x) {
  parallel_for(x.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::array<PointNeighbour, kCandidates> near;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t n = tree.nearest(x[i], near, reach);
      for (std::size_t k = 0; k < n; ++k) {
        const Vec3& normal = cloth.normals[near[k].index];
        if (normal.dot(normals[i]) < kSimilar) continue;
        const Vec3 way = cloth.positions[near[k].index] - x[i];
        // Mostly along the normal, so that the cloth slides on the surface.
        const double off = way.dot(normal);
        x[i] += kPull * (off * normal + 0.1 * (way - off * normal));
        break;
      }
    }
  });
}

}  // namespace

void LayOptions::check() const {
  if (rounds < 0 || rounds > 10000)
    throw InvalidInput("LayOptions: rounds must lie between 0 and 10000");
  if (!(reach > 0)) throw InvalidInput("LayOptions: reach must be positive");
}

std::vector<Vec3> lay_on_scan(const Pattern& pattern, const std::vector<Vec3>& placed,
                              const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth,
                              const std::map<std::string, std::vector<Vec3>>& edge_curves,
                              const LayOptions& options) {
  options.check();
  if (placed.size() != pattern.flat.size() || cloth.size() != samples.size())
    throw InvalidInput("lay_on_scan: one position per pattern vertex and one mark per sample");
  const Cloth target = cloth_samples(samples, cloth);
  if (target.positions.empty()) return placed;
  const PointTree tree(target.positions);
  std::vector<Vec3> x = particle_positions(pattern, placed);
  const std::vector<Spring> links = springs(pattern);
  for (int round = 0; round < options.rounds; ++round) {
    pull_to_scan(tree, target, worn_normals(pattern, x), options.reach, x);
    for (const PatternEdge& edge : pattern.edges) {
      const auto curve = edge_curves.find(edge.name);
      if (curve == edge_curves.end()) continue;
      for (int v : edge.vertices) {
        Vec3& p = x[pattern.particle[v]];
        p += kEdgePull * (closest_on_curve(curve->second, p).point - p);
      }
    }
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (const Spring& s : links) {
        const Vec3 d = x[s.particle_b] - x[s.particle_a];
        const double length = d.norm();
        if (length < 1e-9) continue;
        const double share = length > s.rest_length ? kSpringShare : kSlackShare;
        const Vec3 move = 0.5 * share * (1 - s.rest_length / length) * d;
        x[s.particle_a] += move;
        x[s.particle_b] -= move;
      }
    }
  }
  pull_to_scan(tree, target, worn_normals(pattern, x), options.reach, x);
  std::vector<Vec3> out;
  for (std::size_t v = 0; v < placed.size(); ++v) out.push_back(x[pattern.particle[v]]);
  return out;
}

}  // namespace regarment
