#include "synthetic/reconstruct_surface.h"

#include <cstdint>
#include <optional>

namespace regarment {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

class SurfaceNet {
 public:
  explicit SurfaceNet(const DistanceField& field)
      : field_(field), below_(std::size_t(field.size[0]) * field.size[1], kNone), here_(below_) {}

  Mesh run() {
    for (int z = 0; z + 1 < field_.size[2]; ++z) {
      std::swap(below_, here_);
      std::fill(here_.begin(), here_.end(), kNone);
      for (int y = 0; y + 1 < field_.size[1]; ++y)
        for (int x = 0; x + 1 < field_.size[0]; ++x)
          if (const auto place = vertex_in(x, y, z)) {
            here_[slot(x, y)] = static_cast<std::uint32_t>(mesh_.positions.size());
            mesh_.positions.push_back(*place);
            join(x, y, z);
          }
    }
    return std::move(mesh_);
  }

 private:
  double at(int x, int y, int z) const { return double{field_.value[field_.index(x, y, z)]}; }
  std::size_t slot(int x, int y) const { return std::size_t(y) * field_.size[0] + x; }

  // Middle of the crossings of the cell whose lowest node is (x, y, z).
  std::optional<Vec3> vertex_in(int x, int y, int z) const {
    std::array<double, 8> corner{};
    int outside = 0;
    for (int i = 0; i < 8; ++i) {
      corner[i] = at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
      outside += corner[i] > 0;
    }
    if (outside == 0 || outside == 8) return std::nullopt;
    Vec3 sum = Vec3::Zero();
    int crossings = 0;
    for (int i = 0; i < 8; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const int j = i | 1 << axis;
        if (j == i || (corner[i] > 0) == (corner[j] > 0)) continue;
        Vec3 crossing(i & 1, i >> 1 & 1, i >> 2);
        crossing[axis] = corner[i] / (corner[i] - corner[j]);
        sum += crossing;
        ++crossings;
      }
    return field_.origin + field_.cell * (Vec3(x, y, z) + sum / crossings);
  }

  // Faces around the three edges that leave node (x, y, z), whose other cells were passed before.
  void join(int x, int y, int z) {
    const bool outside = at(x, y, z) > 0;
    const std::uint32_t own = here_[slot(x, y)];
    if (y > 0 && z > 0 && (at(x + 1, y, z) > 0) != outside)
      face({below_[slot(x, y - 1)], below_[slot(x, y)], own, here_[slot(x, y - 1)]}, outside);
    if (z > 0 && x > 0 && (at(x, y + 1, z) > 0) != outside)
      face({below_[slot(x - 1, y)], here_[slot(x - 1, y)], own, below_[slot(x, y)]}, outside);
    if (x > 0 && y > 0 && (at(x, y, z + 1) > 0) != outside)
      face({here_[slot(x - 1, y - 1)], here_[slot(x, y - 1)], own, here_[slot(x - 1, y)]}, outside);
  }

  // Counter-clockwise seen from the end of the edge; that end is outside unless `turned`.
  void face(std::array<std::uint32_t, 4> c, bool turned) {
    if (turned) std::swap(c[1], c[3]);
    const std::vector<Vec3>& p = mesh_.positions;
    if ((p[c[0]] - p[c[2]]).squaredNorm() <= (p[c[1]] - p[c[3]]).squaredNorm()) {
      mesh_.triangles.push_back({c[0], c[1], c[2]});
      mesh_.triangles.push_back({c[0], c[2], c[3]});
    } else {
      mesh_.triangles.push_back({c[0], c[1], c[3]});
      mesh_.triangles.push_back({c[1], c[2], c[3]});
    }
  }

  const DistanceField& field_;
  std::vector<std::uint32_t> below_, here_;  // vertex of each cell of two slices
  Mesh mesh_;
};

}  // namespace

Mesh zero_surface(const DistanceField& field) { return SurfaceNet(field).run(); }

}  // namespace regarment
