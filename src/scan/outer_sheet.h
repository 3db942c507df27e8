#pragma once

#include <optional>
#include <span>

#include "geometry/mesh.h"

namespace regarment {

/// A flat sheet at the outside of a scan: the floor someone stands on, the wall behind them.
struct OuterSheet {
  Vec3 normal = Vec3::UnitY();  // unit, towards the body
  double offset = 0.0;          // normal . p = offset on the sheet
  double thickness = 0.0;       // points at most this far from the plane are the sheet's

  /// Height of a point over the plane, > 0 on the body's side.
  double above(const Vec3& p) const { return normal.dot(p) - offset; }
  /// Whether `p` lies on the sheet, or beyond it.
  bool takes(const Vec3& p) const { return above(p) <= thickness; }
};

/// The sheet with most points near the outside of `points`, which are about `cell` apart. Looks in
/// all directions. Nothing where all else does not lie on one side of it, or where it ends with
/// what stands on it, as a sole does, or the surface invented to close a hem.
std::optional<OuterSheet> find_outer_sheet(std::span<const Vec3> points, double cell);

/// The same plane fitted to the points of a scan: `points` are all of it. Sets the thickness by how
/// far points scatter about the plane, between an eighth and half a `cell`.
OuterSheet refine_sheet(OuterSheet sheet, std::span<const Vec3> points, double cell);

}  // namespace regarment
