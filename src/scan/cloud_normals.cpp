#include "scan/cloud_normals.h"

#include <array>
#include <cmath>

#include "geometry/parallel.h"
#include "scan/visible_side.h"

namespace regarment {
namespace {

constexpr double kPixel =
    2.5;  // spacings: few enough holes in a depth picture, fingers still apart
constexpr std::size_t kLookAt = 2;      // of so many points one is looked at
constexpr std::size_t kHideBehind = 3;  // and one hides others: two in a pixel
constexpr int kRounds = 12;             // of asking the neighbours
constexpr float kOwnShare = 0.4F;       // weight of what a point sees itself
constexpr double kAlong = 0.7;          // cosine: a given normal lies along the estimated one
constexpr double kPlausible = 0.7;      // share of given normals that must
constexpr double kNearlyAll =
    0.9;  // share of these that must point one way to be trusted as a whole

template <typename Item>
std::vector<Item> every(std::span<const Item> items, std::size_t step) {
  std::vector<Item> some;
  some.reserve(items.size() / step + 1);
  for (std::size_t i = 0; i < items.size(); i += step) some.push_back(items[i]);
  return some;
}

/// The side some of the points are seen from, 0 for the others: their neighbours tell them.
std::vector<float> look_at_some(std::span<const Vec3> points, double spacing,
                                std::span<const Vec3> normals) {
  const std::vector<float> looked = visible_side(every(points, kLookAt), every(normals, kLookAt),
                                                 every(points, kHideBehind), kPixel * spacing);
  std::vector<float> seen(points.size(), 0.0F);
  for (std::size_t i = 0; i < looked.size(); ++i) seen[kLookAt * i] = looked[i];
  return seen;
}

}  // namespace

void orient_outward(std::span<const Vec3> points, double spacing, LocalSurface& surface) {
  const std::vector<float> seen = look_at_some(points, spacing, surface.normals);
  // How much each neighbour's answer counts: for the same side or, where normals were estimated
  // opposite, for the other.
  std::vector<std::array<float, LocalSurface::kKept>> agreement(points.size());
  parallel_for(points.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t n = 0; n < LocalSurface::kKept; ++n) {
        const Vec3& theirs = surface.normals[surface.nearest[i][n]];
        agreement[i][n] =
            static_cast<float>(static_cast<double>((1 - kOwnShare) / LocalSurface::kKept) *
                               surface.normals[i].dot(theirs));
      }
    }
  });
  std::vector<float> side = seen, next(seen.size());
  for (int round = 0; round < kRounds; ++round) {
    parallel_for(points.size(), 8192, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        float sum = kOwnShare * seen[i];
        for (std::size_t n = 0; n < LocalSurface::kKept; ++n) {
          sum += agreement[i][n] * side[surface.nearest[i][n]];
        }
        next[i] = sum;
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
