#include "joint/refine.h"

#include <algorithm>

#include "garment/plane.h"

namespace regarment {

std::vector<Vec3> refine(const Pattern& coarse, const std::vector<Vec3>& x, const Pattern& fine) {
  std::vector<Vec3> sum(fine.particle_count, Vec3::Zero());
  std::vector<double> count(fine.particle_count, 0.0);
  for (std::size_t v = 0; v < fine.flat.size(); ++v) {
    double best = -1e18;  // least share: below zero when the point lies outside
    Vec3 at = Vec3::Zero();
    for (const Triangle& t : coarse.triangles) {
      if (coarse.panel[t[0]] != fine.panel[v]) continue;
      const Vec3 share =
          barycentric(coarse.flat[t[0]], coarse.flat[t[1]], coarse.flat[t[2]], fine.flat[v]);
      if (!(share.minCoeff() > best)) continue;
      best = share.minCoeff();
      at = Vec3::Zero();
      for (int c = 0; c < 3; ++c) at += share[c] * x[coarse.particle[t[c]]];
      if (best >= 0) break;
    }
    sum[fine.particle[v]] += at, count[fine.particle[v]] += 1;
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(1.0, count[i]);
  return sum;
}

}  // namespace regarment
