#include "render/vertex_clusters.h"

#include <algorithm>
#include <bit>

namespace regarment {
namespace {

// 0: no normal; 1..6: the axis it is nearest to, with its sign.
std::uint64_t main_direction(const Vec3& normal) {
  Eigen::Index axis = 0;
  if (!(normal.cwiseAbs().maxCoeff(&axis) > 0.0)) return 0;
  return std::uint64_t(1 + 2 * axis + (normal[axis] < 0.0 ? 1 : 0));
}

std::uint64_t key_of(const Vec3& position, const Vec3& low, double inverse_cell) {
  const auto index = [&](int axis) {
    return std::uint64_t(std::max((position[axis] - low[axis]) * inverse_cell, 0.0)) & 0x7ffff;
  };
  return (index(0) << 19 | index(1)) << 19 | index(2);
}

// Open addressing: keys to numbers in the order of their first appearance.
class Numbering {
 public:
  explicit Numbering(std::size_t keys)
      : keys_(std::bit_ceil(2 * keys + 1), kFree), numbers_(keys_.size()) {}

  std::uint32_t number_of(std::uint64_t key) {
    std::size_t slot = (key * 0x9e3779b97f4a7c15ULL >> 20) & (keys_.size() - 1);
    while (keys_[slot] != key) {
      if (keys_[slot] == kFree) {
        keys_[slot] = key;
        return numbers_[slot] = count_++;
      }
      slot = (slot + 1) & (keys_.size() - 1);
    }
    return numbers_[slot];
  }
  std::size_t count() const { return count_; }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t(0);
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> numbers_;
  std::uint32_t count_ = 0;
};

}  // namespace

VertexClusters cluster_vertices(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                std::span<const std::uint8_t> labels,
                                std::span<const std::uint8_t> outlier, const Vec3& low,
                                double cell) {
  VertexClusters clusters;
  clusters.of_vertex.assign(positions.size(), VertexClusters::kLeftOut);
  Numbering numbering(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!outlier.empty() && outlier[i] != 0) continue;
    std::uint64_t key = key_of(positions[i], low, 1.0 / cell);
    key = key << 3 | (normals.empty() ? 0 : main_direction(normals[i]));
    key = key << 4 | (labels.empty() ? 0 : labels[i] & 15);
    clusters.of_vertex[i] = numbering.number_of(key);
  }
  clusters.count = numbering.count();
  return clusters;
}

}  // namespace regarment
