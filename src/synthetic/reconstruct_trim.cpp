#include "synthetic/reconstruct_trim.h"

#include <cstdint>
#include <numeric>

#include "geometry/point_tree.h"

namespace regarment {
namespace {

// Keeps the triangles marked, and the vertices they use.
void keep_triangles(const std::vector<std::uint8_t>& kept, Mesh& mesh) {
  std::vector<std::uint32_t> to(mesh.positions.size(), 0);
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < kept.size(); ++t) {
    if (kept[t] == 0) continue;
    triangles.push_back(mesh.triangles[t]);
    for (const std::uint32_t v : mesh.triangles[t]) to[v] = 1;
  }
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == 0) continue;
    to[v] = static_cast<std::uint32_t>(positions.size());
    positions.push_back(mesh.positions[v]);
  }
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = to[v];
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

}  // namespace

void drop_small_pieces(int least, Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : {t[1], t[2]}) parent[root_of(parent, v)] = root_of(parent, t[0]);
  std::vector<int> size(parent.size(), 0);
  for (const Triangle& t : mesh.triangles) ++size[root_of(parent, t[0])];
  std::vector<std::uint8_t> kept;
  for (const Triangle& t : mesh.triangles)
    kept.push_back(size[root_of(parent, t[0])] >= least ? 1 : 0);
  keep_triangles(kept, mesh);
}

void drop_far_triangles(std::span<const Vec3> points, double reach, Mesh& mesh) {
  const PointTree tree(points);
  std::vector<std::uint8_t> near;
  for (const Vec3& p : mesh.positions) {
    PointNeighbour found;
    near.push_back(tree.nearest(p, {&found, 1}, reach) > 0 ? 1 : 0);
  }
  std::vector<std::uint8_t> kept;
  for (const Triangle& t : mesh.triangles) kept.push_back(near[t[0]] & near[t[1]] & near[t[2]]);
  keep_triangles(kept, mesh);
}

}  // namespace regarment
