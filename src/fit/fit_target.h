#pragma once

#include <vector>

#include "fit/person_outline.h"
#include "geometry/closest_point.h"

namespace regarment {

/// What a garment is fitted to: the whole person's surface, for closest points, and the person's
/// silhouettes from four sides, drawn once [Hasler et al. 2007, sec. 3.3]. Immutable; several runs
/// may share it.
class FitTarget {
 public:
  /// `scan`: body frame, m, mesh or cloud with normals. `masked`: per triangle of a mesh, per point
  /// of a cloud: 1 = neither attracts nor counts; or empty. `spacing`: m, mean distance between
  /// the points of a cloud, each drawn as a square of twice that width; not used for a mesh.
  /// Silhouettes are masks of `silhouette_size` x `silhouette_size` pixels. Draws in the thread
  /// that calls. `shares`: per triangle or point, 0..1, how strongly it attracts; or empty. Throws
  /// InvalidInput when nothing is left unmasked or there are not as many shares.
  FitTarget(const Mesh& scan, const std::vector<std::uint8_t>& masked, double spacing,
            int silhouette_size, std::vector<float> shares = {});

  const ClosestPoint& surface() const { return surface_; }
  const std::vector<float>& shares() const { return shares_; }
  const std::vector<Silhouette>& silhouettes() const { return outline_.silhouettes; }
  const std::vector<Camera>& cameras() const { return outline_.cameras; }

 private:
  ClosestPoint surface_;
  std::vector<float> shares_;
  PersonOutline outline_;
};

}  // namespace regarment
