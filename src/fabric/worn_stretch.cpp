#include "fabric/worn_stretch.h"

#include <cmath>

#include "base/error.h"
#include "fabric/dimension_role.h"
#include "fabric/hoop_bands.h"
#include "fabric/stretch_prior.h"

namespace regarment {
namespace {

void check(const Pattern& pattern, const std::vector<Vec3>& draped) {
  if (draped.size() != pattern.flat.size()) {
    throw InvalidInput("worn_stretch: " + std::to_string(draped.size()) + " positions for " +
                       std::to_string(pattern.flat.size()) + " vertices of the pattern");
  }
  for (const Vec3& p : draped) {
    if (!p.allFinite()) throw InvalidInput("worn_stretch: a position is not finite");
  }
}

// What no model of cloth gets nearer to: the same line followed by two makers of drapes.
constexpr double kLeastDeviation = 0.002;

// Of a prior alone: the mean and the spread of exp(x) - 1, x log-normal and small.
Stretch expected(const StretchPrior& prior) {
  const double variance = prior.spread * prior.spread;
  const double mean = prior.median * std::exp(0.5 * variance);
  const double square = mean * mean * std::exp(variance);
  return {prior.tight * mean,
          std::sqrt(prior.tight * square - prior.tight * prior.tight * mean * mean)};
}

}  // namespace

void StretchOptions::check() const {
  if (!(cloth_error >= 1e-5 && cloth_error <= 0.1)) {
    throw InvalidInput("StretchOptions.cloth_error must be 1e-5 to 0.1 m, not " +
                       std::to_string(cloth_error));
  }
}

std::map<std::string, Stretch> worn_stretch(const GarmentTemplate& garment, const Dimensions& worn,
                                            const Pattern& pattern, const std::vector<Vec3>& draped,
                                            const StretchOptions& options) {
  options.check();
  check(pattern, draped);
  std::map<std::string, Stretch> out;
  std::map<std::string, DimensionRole> roles;
  std::vector<std::string> hoops, seams;
  for (const Dimension& dimension : garment.dimensions()) {
    const std::string& name = dimension.name;
    roles[name] = dimension_role(garment, worn, pattern, name);
    out[name] = expected(stretch_prior(roles[name], options.fabric, 0.0));
    if (roles[name] == DimensionRole::Seam) {
      seams.push_back(name);
    } else if (dimension.circumference) {
      hoops.push_back(name);
    }
  }
  for (const HoopFamily& family : hoop_families(garment, worn, pattern, draped, hoops, seams)) {
    std::vector<StretchPrior> priors;
    for (std::size_t d = 0; d < family.dimensions.size(); ++d) {
      const DimensionRole role = roles.at(family.dimensions[d]);
      priors.push_back(stretch_prior(role, options.fabric, family.folds[d]));
    }
    const std::vector<Stretch> explained = explain_bands(family, priors, options.cloth_error);
    for (std::size_t d = 0; d < explained.size(); ++d) out[family.dimensions[d]] = explained[d];
  }
  for (auto& [name, stretch] : out) {
    stretch.standard_deviation = std::hypot(stretch.standard_deviation, kLeastDeviation);
  }
  return out;
}

}  // namespace regarment
