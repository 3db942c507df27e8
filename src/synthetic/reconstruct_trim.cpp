#include "synthetic/reconstruct_trim.h"

#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

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

// What of a mesh lies beyond a plane and hangs together with where the plane meets it.
class CutPart {
 public:
  CutPart(const FlatCut& cut, const Mesh& mesh) : parent_(mesh.positions.size()) {
    for (const Vec3& p : mesh.positions) side_.push_back(cut.normal.dot(p - cut.point));
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k)
        if (beyond(t[k]) && beyond(t[(k + 1) % 3]))
          parent_[root_of(parent_, t[k])] = root_of(parent_, t[(k + 1) % 3]);
    meets_cut_.assign(parent_.size(), 0);
    const auto near = [&](std::uint32_t v) {
      return (mesh.positions[v] - cut.point).norm() <= cut.radius;
    };
    for (const Triangle& t : mesh.triangles) {
      const int over = beyond(t[0]) + beyond(t[1]) + beyond(t[2]);
      if (over == 0 || over == 3 || !near(t[0]) || !near(t[1]) || !near(t[2])) continue;
      for (const std::uint32_t v : t)
        if (beyond(v)) meets_cut_[root_of(parent_, v)] = 1;
    }
  }

  bool holds(std::uint32_t v) { return beyond(v) && meets_cut_[root_of(parent_, v)] != 0; }
  /// How much of the way from a vertex outside the part to one in it lies before the plane.
  double share(std::uint32_t outside, std::uint32_t inside) const {
    return side_[outside] / (side_[outside] - side_[inside]);
  }

 private:
  bool beyond(std::uint32_t v) const { return side_[v] > 0; }

  std::vector<double> side_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> meets_cut_;  // of roots
};

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

void cut_flat(const FlatCut& cut, Mesh& mesh) {
  CutPart part(cut, mesh);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> made;
  const auto between = [&](std::uint32_t outside, std::uint32_t inside) {
    const auto [found, is_new] =
        made.try_emplace({outside, inside}, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      const Vec3 from = mesh.positions[outside], to = mesh.positions[inside];
      mesh.positions.push_back(from + part.share(outside, inside) * (to - from));
    }
    return found->second;
  };
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    const int gone = part.holds(t[0]) + part.holds(t[1]) + part.holds(t[2]);
    if (gone == 0) triangles.push_back(t);
    if (gone == 0 || gone == 3) continue;
    int lone = 0;  // the corner on a side of its own
    while (part.holds(t[lone]) != (gone == 1)) ++lone;
    const std::uint32_t a = t[lone], b = t[(lone + 1) % 3], c = t[(lone + 2) % 3];
    if (gone == 2) {
      triangles.push_back({a, between(a, b), between(a, c)});
    } else {
      triangles.push_back({between(b, a), b, c});
      triangles.push_back({between(b, a), c, between(c, a)});
    }
  }
  mesh.triangles = std::move(triangles);
  keep_triangles(std::vector<std::uint8_t>(mesh.triangles.size(), 1), mesh);
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
