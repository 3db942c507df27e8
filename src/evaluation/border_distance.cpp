#include "evaluation/border_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "geometry/point_tree.h"

namespace regarment {
namespace {

constexpr std::uint8_t kNotScored = 255;
constexpr std::size_t kNearest = 6;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

void add_cloud_pairs(const Mesh& mesh, std::vector<Pair>& pairs) {
  const PointTree tree(mesh.positions);
  std::array<PointNeighbour, kNearest + 1> found;  // the point itself is among them
  for (const std::uint32_t i : tree.order()) {
    const std::size_t count = tree.nearest(mesh.positions[i], found);
    for (std::size_t k = 0; k < count; ++k) {
      if (found[k].index != i) pairs.push_back(std::minmax(i, found[k].index));
    }
  }
}

std::vector<Vec3> border(const Mesh& mesh, const std::vector<Pair>& pairs,
                         const std::vector<std::uint8_t>& labels,
                         const std::vector<std::uint8_t>& truth) {
  std::vector<Vec3> points;
  for (const auto& [a, b] : pairs) {
    if (truth[a] == kNotScored || truth[b] == kNotScored || labels[a] == labels[b]) continue;
    points.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
  }
  return points;
}

double mean_distance(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  const PointTree tree(to);
  double sum = 0;
  for (const Vec3& point : from) {
    std::array<PointNeighbour, 1> nearest;
    tree.nearest(point, nearest);
    sum += std::sqrt(nearest[0].squared_distance);
  }
  return sum / static_cast<double>(from.size());
}

}  // namespace

std::vector<Pair> neighbours(const Mesh& mesh) {
  std::vector<Pair> pairs;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) pairs.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  }
  if (mesh.is_cloud() && !mesh.positions.empty()) add_cloud_pairs(mesh, pairs);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::optional<double> border_distance(const Mesh& mesh, const std::vector<std::uint8_t>& labels,
                                      const std::vector<std::uint8_t>& truth) {
  if (labels.size() != mesh.positions.size() || truth.size() != labels.size()) {
    throw InvalidInput("labels and vertices differ in number");
  }
  const std::vector<Pair> pairs = neighbours(mesh);
  const std::vector<Vec3> found = border(mesh, pairs, labels, truth);
  const std::vector<Vec3> real = border(mesh, pairs, truth, truth);
  if (found.empty() || real.empty()) return std::nullopt;
  return 0.5 * (mean_distance(found, real) + mean_distance(real, found));
}

}  // namespace regarment
