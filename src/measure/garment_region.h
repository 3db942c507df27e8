#pragma once

#include <vector>

#include "measure/garment_edges.h"

namespace regarment {

/// The part of a scan between the edges of one garment. Borrows `edges` and `body`, which must
/// outlive it.
class GarmentRegion {
 public:
  GarmentRegion(const GarmentEdges& edges, const Body& body) : edges_(edges), body_(body) {}

  /// How far inside the garment's border a point of the scan lies, along the limb, m: positive
  /// inside, negative outside, about zero at an edge. `part` is where the point belongs on the
  /// body.
  double depth(const Vec3& p, BodyPart part) const;

 private:
  double depth_on_torso(const Vec3& p) const;
  bool on_fold(const Vec3& p) const;
  double depth_on_arm(const Vec3& p, int side) const;

  const GarmentEdges& edges_;
  const Body& body_;
};

}  // namespace regarment
