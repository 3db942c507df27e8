#pragma once

#include <vector>

#include "drape/cloth.h"
#include "geometry/closest_point.h"

namespace regarment {

struct AttractionOptions {
  // Only what faces the same way as the cloth attracts it [sec. 3.4]; false: the closest point.
  bool by_normals = true;
  // Largest angle between the normals, rad. Larger lets more of the scan attract, up to the far
  // side of a limb at pi / 2.
  double normal_angle = 1.0471975511965976;  // 60 degrees
  // A closest point on the border of an open scan does not attract, so that holes are bridged and
  // a hem is not pushed up [sec. 3.4, Fig. 5]. False: as printed.
  bool border_rejection = true;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// Where the cloth is pulled to: d(p, M) of sec. 3.2, one entry per particle.
struct Attraction {
  Vec3 target = Vec3::Zero();  // closest allowed point of the scan, m
  Vec3 normal = Vec3::Zero();  // of the scan there, unit, or zero
  double distance = 0;         // |target - particle|, m
  bool found = false;          // false: nothing of the scan may attract this particle
  bool pulls = false;          // found, and not rejected
  double weight = 1;           // share of k_a it is pulled with, 0..1
  double share = 1;            // how strongly that part of the scan attracts, 0..1; both count
};

/// Closest points of the scan for all particles. `any_side`: one per particle, 1 = its normal is
/// not looked at; or empty. `shares`: one per element of the scan, 0..1, how strongly it attracts:
/// what an outer garment hides is only supported by it [sec. 3.6]; or empty, all fully.
std::vector<Attraction> attract(const Cloth& cloth, const ClosestPoint& scan,
                                const AttractionOptions& options,
                                const std::vector<std::uint8_t>& any_side = {},
                                const std::vector<float>& shares = {});

/// E_dist of sec. 3.3: mean over the particles of |d(p, M)|, m. A particle for which nothing was
/// found counts with `far`; one that is not pulled counts with its distance.
double mean_distance(const std::vector<Attraction>& attraction, double far = 0.1);

}  // namespace regarment
