#pragma once

#include <vector>

#include "geometry/closest_point.h"
#include "joint/joint_model.h"

namespace regarment {

/// A garment on the body that lies over the one to fit. Body frame, metres. Triangles face outwards
/// and share the particles of a seam, so that its borders are its open edges.
struct OuterGarment {
  std::vector<Vec3> particles;
  std::vector<Triangle> triangles;
};

/// The garment of `pattern` as it lies on the body. `draped`: one position per pattern vertex.
OuterGarment outer_garment(const Pattern& pattern, const std::vector<Vec3>& draped);

/// Where cloth may not go through other cloth.
struct InsideOptions {
  double reach = 0.12;       // m, an outer garment further off hides nothing
  double thickness = 0.002;  // m, between the middles of both cloths
  double scale = 0.003;      // m: so far beyond counts one standard deviation, per patch of cloth
  double robust = 0.02;      // m: so far beyond counts a quarter, it may be the outer one that errs
  double min_cosine = 0.3;   // between the normals of both
};

/// Bounds every particle that an outer garment covers to that garment's inner side; replaces
/// model.inside. A particle whose nearest place on an outer garment is that one's open edge lies
/// beyond it and stays free. `shown`: share of the cloth round each particle that the scan shows,
/// 0..1: as much of its bound is waived, since the scan knows better where it lies.
void bound_inside(const std::vector<ClosestPoint>& outer, const std::vector<Vec3>& x,
                  const std::vector<double>& shown, const InsideOptions& options,
                  JointModel& model);

}  // namespace regarment
