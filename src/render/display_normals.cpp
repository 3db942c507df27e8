#include "render/display_normals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/error.h"

namespace regarment {
namespace {

// Numbers equal places alike. Sorting keeps it independent of any hash.
std::vector<std::uint32_t> first_at_same_place(std::span<const Vec3> positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = positions[a], &q = positions[b];
    return std::tie(p.x(), p.y(), p.z(), a) < std::tie(q.x(), q.y(), q.z(), b);
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

// The points of each cell of a grid, to look through the 27 cells round a point.
class Cells {
 public:
  Cells(std::span<const Eigen::Vector3f> points, float cell) : points_(points), cell_(cell) {
    for (std::uint32_t i = 0; i < points.size(); ++i) next_.push_back(~0U);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      auto [entry, is_new] = head_.try_emplace(key(index(points[i])), i);
      if (!is_new) next_[i] = std::exchange(entry->second, i);
    }
  }

  template <typename Visit>
  void visit_around(const Eigen::Vector3f& point, Visit visit) const {
    const Eigen::Vector3i middle = index(point);
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const auto found = head_.find(key(middle + step));
      if (found == head_.end()) continue;
      for (std::uint32_t i = found->second; i != ~0U; i = next_[i]) visit(points_[i]);
    }
  }

 private:
  Eigen::Vector3i index(const Eigen::Vector3f& p) const {
    return (p / cell_).array().floor().matrix().cast<int>();
  }
  static std::uint64_t key(const Eigen::Vector3i& i) {
    const auto part = [](int value) { return std::uint64_t(value) & 0x1fffff; };
    return part(i.x()) << 42 | part(i.y()) << 21 | part(i.z());
  }

  std::span<const Eigen::Vector3f> points_;
  float cell_;
  std::unordered_map<std::uint64_t, std::uint32_t> head_;
  std::vector<std::uint32_t> next_;  // chain of the points of one cell
};

}  // namespace

Eigen::Vector3f unit_or_zero(const Vec3& vector) {
  const double length = vector.norm();
  if (!(length > 1e-30) || !std::isfinite(length)) return Eigen::Vector3f::Zero();
  return (vector / length).cast<float>();
}

std::vector<Vec3> vertex_normals(std::span<const Vec3> positions,
                                 std::span<const Triangle> triangles) {
  std::vector<Vec3> normals(positions.size(), Vec3::Zero());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (std::max({a, b, c}) >= positions.size()) {
      throw InvalidInput("triangle " + std::to_string(t) + " names vertex " +
                         std::to_string(std::max({a, b, c})) + ", there are " +
                         std::to_string(positions.size()));
    }
    const Vec3 normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += normal;
  }
  return normals;
}

std::vector<Vec3> welded_normals(std::span<const Vec3> positions,
                                 std::span<const Triangle> triangles) {
  std::vector<Vec3> normals = vertex_normals(positions, triangles);
  const std::vector<std::uint32_t> first = first_at_same_place(positions);
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) normals[first[i]] += normals[i];
  }
  for (std::uint32_t i = 0; i < first.size(); ++i) normals[i] = normals[first[i]];
  return normals;
}

std::vector<Eigen::Vector3f> cloud_normals(std::span<const Eigen::Vector3f> points,
                                           double spacing) {
  const Cells cells(points, static_cast<float>(1.5 * spacing));
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
    float count = 0.0F;
    cells.visit_around(point, [&](const Eigen::Vector3f& neighbour) {
      const Eigen::Vector3f offset = neighbour - point;
      sum += offset;
      products += offset * offset.transpose();
      count += 1.0F;
    });
    if (count < 3.0F) {
      normals.emplace_back(Eigen::Vector3f::Zero());
      continue;
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(products - sum * sum.transpose() / count);
    normals.emplace_back(solver.eigenvectors().col(0));
  }
  return normals;
}

}  // namespace regarment
