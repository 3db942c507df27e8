#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// A place on a closed curve.
struct CurvePoint {
  Vec3 point = Vec3::Zero();
  Vec3 along =
      Vec3::Zero();       // the piece it lies on, from end to end; zero where that has no length
  std::size_t piece = 0;  // of the curve, the first begins at the first point
  double share = 0;       // of that piece that lies before the place, 0..1
};

/// The place nearest to `p` on the closed polyline through `curve`, first point not repeated; of
/// several the first. `curve` holds at least one point.
CurvePoint closest_on_curve(const std::vector<Vec3>& curve, const Vec3& p);

}  // namespace regarment
