#include "drape/attraction.h"

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.h"

namespace regarment {
namespace {

Attraction attraction_to(const ClosestHit& hit, const Vec3& particle, bool border_rejection) {
  Attraction out;
  out.found = hit.found();
  if (!out.found) return out;
  out.target = hit.point;
  out.normal = hit.normal;
  out.distance = (hit.point - particle).norm();
  out.pulls = !(border_rejection && hit.on_border);
  return out;
}

}  // namespace

void AttractionOptions::check() const {
  if (!(normal_angle > 0 && normal_angle <= std::numbers::pi))
    throw InvalidInput("AttractionOptions: normal_angle must lie between 0 and pi, not " +
                       std::to_string(normal_angle));
}

std::vector<Attraction> attract(const Cloth& cloth, const ClosestPoint& scan,
                                const AttractionOptions& options,
                                const std::vector<std::uint8_t>& any_side,
                                const std::vector<float>& shares) {
  const std::vector<Vec3> normals =
      options.by_normals ? particle_normals(cloth) : std::vector<Vec3>(cloth.size(), Vec3::Zero());
  std::vector<Attraction> out;
  out.reserve(cloth.size());
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    ClosestFilter filter;
    if (!normals[i].isZero(0) && (any_side.empty() || any_side[i] == 0)) {
      filter.normal = normals[i];
      filter.min_cosine = std::cos(options.normal_angle);
    }
    const ClosestHit hit = scan.closest(cloth.positions[i], filter);
    out.push_back(attraction_to(hit, cloth.positions[i], options.border_rejection));
    if (hit.found() && !shares.empty()) out.back().share = shares.at(hit.element);
  }
  return out;
}

double mean_distance(const std::vector<Attraction>& attraction, double far) {
  if (attraction.empty()) return 0;
  double sum = 0;
  for (const Attraction& a : attraction) sum += a.found ? a.distance : far;
  return sum / static_cast<double>(attraction.size());
}

}  // namespace regarment
