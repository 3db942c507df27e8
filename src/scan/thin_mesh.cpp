#include "scan/thin_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "scan/robust.h"

namespace regarment {
namespace {

constexpr int kMostTries = 24;                // of cell sizes
constexpr double kNearEnough = 0.25;          // of the number wanted
constexpr double kFirstCells = 600;           // along the longest side, tried first
constexpr std::int64_t kMostCells = 1 << 19;  // from the middle to each side; beyond, the last cell
constexpr std::size_t kLookAt = 20'000;       // points the extent is judged by

/// Which of six ways each vertex faces, by its triangles; 0 throughout for a cloud.
std::vector<std::uint8_t> facings(const Mesh& mesh) {
  std::vector<std::uint8_t> facing(mesh.positions.size(), 0);
  if (mesh.is_cloud()) return facing;
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 area =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    if (!area.allFinite()) continue;
    for (const std::uint32_t v : {a, b, c}) sums[v] += area;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    int axis = 0;
    sums[v].cwiseAbs().maxCoeff(&axis);
    facing[v] = static_cast<std::uint8_t>(2 * axis + (sums[v][axis] < 0 ? 1 : 0));
  }
  return facing;
}

struct Extent {
  Vec3 middle;
  double longest;
};

Extent extent_of(const std::vector<Vec3>& points) {
  std::vector<Vec3> some;
  const std::size_t step = points.size() / kLookAt + 1;
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (points[i].allFinite()) some.push_back(points[i]);
  }
  Extent extent{Vec3::Zero(), 0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [&](const Vec3& p) { return p[axis]; };
    const double low = quantile_of(some, 0.01, along), high = quantile_of(some, 0.99, along);
    extent.middle[axis] = (low + high) / 2;
    extent.longest = std::max(extent.longest, high - low);
  }
  return extent;
}

/// The number of a point's cell and facing.
std::uint64_t key_of(const Vec3& p, const Vec3& middle, double cell, std::uint8_t facing) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double at = std::floor((p[axis] - middle[axis]) / cell);
    const auto bound = static_cast<double>(kMostCells - 1);
    const auto whole = static_cast<std::int64_t>(std::clamp(at, -bound, bound)) + kMostCells;
    key = key << 20 | static_cast<std::uint64_t>(whole);
  }
  return key << 3 | facing;
}

struct Keyed {
  std::uint64_t key;
  std::uint32_t vertex;
};

std::vector<Keyed> keyed_vertices(const Mesh& mesh, const std::vector<std::uint8_t>& facing,
                                  const Vec3& middle, double cell) {
  std::vector<Keyed> keyed;
  keyed.reserve(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (p.allFinite()) keyed.push_back({key_of(p, middle, cell, facing[v]), v});
  }
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
    return std::tie(a.key, a.vertex) < std::tie(b.key, b.vertex);
  });
  return keyed;
}

std::size_t count_keys(const std::vector<Keyed>& keyed) {
  std::size_t count = keyed.empty() ? 0 : 1;
  for (std::size_t i = 1; i < keyed.size(); ++i) count += keyed[i].key != keyed[i - 1].key ? 1 : 0;
  return count;
}

/// Vertices by cells of a size that leaves about `wanted` of them.
std::vector<Keyed> grouped(const Mesh& mesh, std::size_t wanted) {
  const std::vector<std::uint8_t> facing = facings(mesh);
  const Extent extent = extent_of(mesh.positions);
  double cell = extent.longest > 0 ? extent.longest / kFirstCells : 1.0;
  std::vector<Keyed> keyed;
  for (int tries = 0; tries < kMostTries; ++tries) {
    keyed = keyed_vertices(mesh, facing, extent.middle, cell);
    const double over = static_cast<double>(count_keys(keyed)) / static_cast<double>(wanted);
    if (std::abs(over - 1) <= kNearEnough) break;
    // A surface has a number of cells that falls with their area.
    cell *= std::sqrt(std::clamp(over, 1e-4, 1e4));
  }
  return keyed;
}

struct Sums {
  Vec3 position = Vec3::Zero(), normal = Vec3::Zero(), colour = Vec3::Zero();
  double count = 0;
};

void append_mean(const Sums& sums, bool normals, bool colours, Mesh& mesh) {
  mesh.positions.push_back(sums.position / sums.count);
  if (normals) mesh.normals.push_back(sums.normal.stableNormalized());
  if (!colours) return;
  Colour colour{};
  for (int i = 0; i < 3; ++i) {
    colour[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(sums.colour[i] / sums.count));
  }
  mesh.colours.push_back(colour);
}

/// The triangles whose corners went to three different vertices, each once.
std::vector<Triangle> thin_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& to) {
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    Triangle thin = {to[t[0]], to[t[1]], to[t[2]]};
    const auto [a, b, c] = thin;
    if (a == b || b == c || c == a || std::max({a, b, c}) == ThinMesh::kNone) continue;
    std::rotate(thin.begin(), std::min_element(thin.begin(), thin.end()), thin.end());
    kept.push_back(thin);
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace

ThinMesh thin_mesh(const Mesh& mesh, std::size_t vertices) {
  const std::vector<Keyed> keyed = grouped(mesh, vertices);
  const bool normals = !mesh.normals.empty(), colours = !mesh.colours.empty();
  ThinMesh thin;
  thin.of_vertex.assign(mesh.positions.size(), ThinMesh::kNone);
  for (std::size_t i = 0; i < keyed.size();) {
    Sums sums;
    const std::uint64_t key = keyed[i].key;
    for (; i < keyed.size() && keyed[i].key == key; ++i) {
      const std::uint32_t v = keyed[i].vertex;
      thin.of_vertex[v] = static_cast<std::uint32_t>(thin.mesh.positions.size());
      sums.position += mesh.positions[v];
      if (normals && mesh.normals[v].allFinite()) sums.normal += mesh.normals[v];
      if (colours) {
        const auto& [red, green, blue] = mesh.colours[v];
        sums.colour += Vec3(red, green, blue);
      }
      sums.count += 1;
    }
    append_mean(sums, normals, colours, thin.mesh);
  }
  thin.mesh.triangles = thin_triangles(mesh, thin.of_vertex);
  return thin;
}

}  // namespace regarment
