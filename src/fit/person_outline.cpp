#include "fit/person_outline.h"

#include <algorithm>

#include "base/error.h"
#include "fit/error_terms.h"

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

}  // namespace

PersonOutline outline_person(const Mesh& scan, const std::vector<std::uint8_t>& masked,
                             double spacing, int size) {
  const Surface shown =
      scan.is_cloud() ? surface_of_cloud(scan, masked, spacing) : surface_of_mesh(scan, masked);
  if (shown.triangles.empty()) throw InvalidInput("outline_person: the scan has no surface left");
  Framing framing;
  framing.width = framing.height = size;
  framing.margin = kMargin;
  PersonOutline out;
  out.cameras = frame_views(box_of(shown), four_sides(), framing);
  SilhouetteRenderer renderer(shown.triangles, shown.positions.size(), size);
  out.silhouettes = renderer.draw(shown.positions, out.cameras);
  return out;
}

std::optional<double> silhouette_error(const PersonOutline& person,
                                       std::span<const Triangle> triangles,
                                       std::span<const Vec3> positions) {
  SilhouetteRenderer renderer(triangles, positions.size(), person.silhouettes.at(0).size);
  const std::vector<Silhouette> garment = renderer.draw(positions, person.cameras);
  const bool unseen = std::any_of(garment.begin(), garment.end(),
                                  [](const Silhouette& side) { return side.area() == 0; });
  if (unseen) return std::nullopt;
  return silhouette_error(person.silhouettes, garment);
}

}  // namespace regarment
