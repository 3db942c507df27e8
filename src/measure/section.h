#pragma once

#include <vector>

#include "geometry/surface_samples.h"
#include "measure/edge_finder.h"

namespace regarment {

/// The outline that a plane cuts out of a surface, as distances from a point in the plane by angle.
/// Right for outlines that a ray from that point meets once: torsos, skirts, sleeves.
struct Section {
  Vec3 centre;            // body frame, m
  Vec3 zero, quarter;     // unit vectors in the plane: angle 0 and 90 degrees
  std::vector<double> r;  // m, one per equal step of angle from -pi; NaN where nothing was cut

  Vec3 point(int bin) const;
  double angle_of(const Vec3& p) const;  // (-pi, pi]
  /// Length of the outline between two points near it, going through `via`: gaps are bridged
  /// straight. NaN when fewer than `min_share` of the bins on the way hold data.
  double length_between(const Vec3& from, const Vec3& to, const Vec3& via,
                        double min_share = 0.3) const;
};

/// Cuts the samples `members` within `half_thickness` of the plane through `centre` spanned by
/// `zero` and `quarter`; in each of `bins` steps of angle those within 8 mm of the outermost are
/// averaged.
Section cut_section(const SurfaceSamples& samples, const std::vector<int>& members,
                    const Vec3& centre, const Vec3& zero, const Vec3& quarter,
                    double half_thickness = 0.006, int bins = 180);

/// The garment next to an edge as a closed curve: the outermost samples between 2 and 12 mm from
/// the edge on the garment's side, by angle round the limb in `bins` steps.
std::vector<Vec3> curve_beside_edge(const SurfaceSamples& samples, const std::vector<int>& members,
                                    const LimbAxis& axis, const LimbMap& map, const FoundEdge& edge,
                                    bool garment_above, int bins = 144);

}  // namespace regarment
