#include "scan/cloud_normals.h"

#include <cmath>

#include "geometry/parallel.h"
#include "scan/visible_side.h"

namespace regarment {
namespace {

constexpr double kPixel =
    2.5;                     // spacings: few enough holes in a depth picture, fingers still apart
constexpr int kRounds = 12;  // of asking the neighbours
constexpr double kOwnShare = 0.4;   // weight of what a point sees itself
constexpr double kAlong = 0.7;      // cosine: a given normal lies along the estimated one
constexpr double kPlausible = 0.7;  // share of given normals that must
constexpr double kNearlyAll =
    0.9;  // share of these that must point one way to be trusted as a whole

}  // namespace

void orient_outward(std::span<const Vec3> points, double spacing, LocalSurface& surface) {
  const std::vector<float> seen = visible_side(points, surface.normals, points, kPixel * spacing);
  std::vector<float> side = seen, next(seen.size());
  for (int round = 0; round < kRounds; ++round) {
    parallel_for(points.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double neighbours = 0;
        for (const std::uint32_t n : surface.nearest[i]) {
          neighbours += static_cast<double>(side[n]) * surface.normals[i].dot(surface.normals[n]);
        }
        next[i] = static_cast<float>(kOwnShare * static_cast<double>(seen[i]) +
                                     (1 - kOwnShare) * neighbours / LocalSurface::kKept);
      }
    });
    side.swap(next);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (side[i] < 0) surface.normals[i] = -surface.normals[i];
  }
}

GivenNormals prefer_given(std::span<const Vec3> given, std::vector<Vec3>& estimated) {
  if (given.empty()) return GivenNormals::Absent;
  std::size_t along = 0, outward = 0;
  for (std::size_t i = 0; i < estimated.size(); ++i) {
    const double cosine = given[i].dot(estimated[i]);
    if (!(std::abs(cosine) > kAlong)) continue;
    ++along;
    if (cosine > 0) ++outward;
  }
  const auto share =
      static_cast<double>(outward) / static_cast<double>(std::max<std::size_t>(along, 1));
  if (static_cast<double>(along) < kPlausible * static_cast<double>(estimated.size())) {
    return GivenNormals::Replaced;
  }
  const bool all_in = share<1 - kNearlyAll, all_out = share> kNearlyAll;
  for (std::size_t i = 0; i < estimated.size(); ++i) {
    const double cosine = given[i].dot(estimated[i]);
    if (!(std::abs(cosine) > kAlong)) continue;
    const bool flip = all_in || (!all_out && cosine < 0);
    estimated[i] = (flip ? -1.0 : 1.0) * given[i].normalized();
  }
  return all_out ? GivenNormals::Kept : all_in ? GivenNormals::Flipped : GivenNormals::Replaced;
}

}  // namespace regarment
