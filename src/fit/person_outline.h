#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "render/camera.h"
#include "render/silhouette.h"

namespace regarment {

/// The outlines of a scanned person from four sides, S_m of Eq. (1) [Hasler et al. 2007, sec. 3.3],
/// and the cameras that saw them, with room for garments wider than the person.
struct PersonOutline {
  std::vector<Camera> cameras;  // front, left, back, right
  std::vector<Silhouette> silhouettes;
};

/// `scan`: body frame, m, mesh or cloud. `masked`: per triangle of a mesh, per point of a cloud:
/// 1 = not drawn; or empty. `spacing`: m, mean distance between the points of a cloud, each drawn
/// as a square of twice that width; not used for a mesh. Masks are `size` x `size` pixels. Draws
/// in the thread that calls. Throws InvalidInput when nothing is left to draw.
PersonOutline outline_person(const Mesh& scan, const std::vector<std::uint8_t>& masked,
                             double spacing, int size);

/// E_sil of one garment at rest, `positions` in the body frame, m. Nothing when it is not seen in
/// one of the pictures.
std::optional<double> silhouette_error(const PersonOutline& person,
                                       std::span<const Triangle> triangles,
                                       std::span<const Vec3> positions);

}  // namespace regarment
