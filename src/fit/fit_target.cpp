#include "fit/fit_target.h"

#include "base/error.h"

namespace regarment {
namespace {

// Room beside the person for garments wider than it, as a share of the picture.
constexpr double kMargin = 0.15;

struct Surface {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

bool left_out(const std::vector<std::uint8_t>& masked, std::size_t i) {
  return !masked.empty() && masked[i] != 0;
}

Surface surface_of_mesh(const Mesh& scan, const std::vector<std::uint8_t>& masked) {
  Surface out{scan.positions, {}};
  out.triangles.reserve(scan.triangles.size());
  for (std::size_t t = 0; t < scan.triangles.size(); ++t)
    if (!left_out(masked, t)) out.triangles.push_back(scan.triangles[t]);
  return out;
}

/// Each point as two upright squares across each other: from each of four sides one shows its face.
Surface surface_of_cloud(const Mesh& scan, const std::vector<std::uint8_t>& masked,
                         double spacing) {
  Surface out;
  const double r = spacing;
  for (std::size_t i = 0; i < scan.positions.size(); ++i) {
    if (left_out(masked, i)) continue;
    for (const Vec3& side : {Vec3(r, 0, 0), Vec3(0, 0, r)}) {
      const auto first = static_cast<std::uint32_t>(out.positions.size());
      const Vec3 up(0, r, 0);
      for (const Vec3& corner :
           {Vec3(-side - up), Vec3(side - up), Vec3(side + up), Vec3(up - side)})
        out.positions.push_back(scan.positions[i] + corner);
      out.triangles.push_back({first, first + 1, first + 2});
      out.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return out;
}

Box box_of(const Surface& surface) {
  Box box;
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) box.add(surface.positions[v]);
  return box;
}

ClosestPoint closest_points(const Mesh& scan, const std::vector<std::uint8_t>& masked) {
  if (scan.is_cloud()) return {std::span(scan.positions), std::span(scan.normals), masked};
  return {std::span(scan.positions), std::span(scan.triangles), masked};
}

}  // namespace

FitTarget::FitTarget(const Mesh& scan, const std::vector<std::uint8_t>& masked, double spacing,
                     int silhouette_size)
    : surface_(closest_points(scan, masked)) {
  if (surface_.empty()) throw InvalidInput("FitTarget: the scan has no surface left to fit to");
  const Surface shown =
      scan.is_cloud() ? surface_of_cloud(scan, masked, spacing) : surface_of_mesh(scan, masked);
  Framing framing;
  framing.width = framing.height = silhouette_size;
  framing.margin = kMargin;
  cameras_ = frame_views(box_of(shown), four_sides(), framing);
  SilhouetteRenderer renderer(shown.triangles, shown.positions.size(), silhouette_size);
  silhouettes_ = renderer.draw(shown.positions, cameras_);
}

}  // namespace regarment
