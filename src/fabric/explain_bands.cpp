#include "fabric/explain_bands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "fabric/posterior_sample.h"

namespace regarment {
namespace {

// All strips of a fitted cloth may be longer by the noise of the scan, or shorter by folds that
// its triangles are too large for.
constexpr double kCommonError = 0.015;
constexpr double kModelError = 0.0015;  // of a strain: what a flat pattern leaves out
// A strip's length errs by this times the cloth's error times the root of its length in m: what it
// goes over errs independently every few centimetres.
constexpr double kGirthError = 1.5;
constexpr double kMostStrain = 0.1;       // of a strip that is tight; any up to it is as likely
constexpr double kLooseStretch = 0.0015;  // of a dimension where the garment is loose
constexpr double kCrumpledShare = 0.02;   // of strips whose triangles do not follow their folds
constexpr double kCrumpledRange = 0.4;    // over which their lengths are spread
// Strips closer than about 5 cm err alike, so each counts as less than one observation.
constexpr double kIndependence = 0.4;

double normal_density(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2 * std::numbers::pi));
}

// Density of a variable spread evenly from 0 to `most` plus a normal one, below `most`.
double tight_density(double x, double most, double sigma) {
  return 0.5 * std::erfc(-x / (sigma * std::numbers::sqrt2)) / most;
}

double log_likelihood(const HoopFamily& family, const std::vector<double>& stretch, double common,
                      double cloth_error) {
  double out = 0;
  for (const HoopBand& band : family.bands) {
    double strain = band.excess - common;
    for (std::size_t d = 0; d < stretch.size(); ++d) strain += band.share[d] * stretch[d];
    const double sigma = std::hypot(kModelError, kGirthError * cloth_error / std::sqrt(band.girth));
    const double tight = tight_share(band.fold);
    const double sound = (1 - tight) * normal_density(strain, sigma) +
                         tight * tight_density(strain, kMostStrain, sigma);
    out += kIndependence * std::log((1 - kCrumpledShare) * sound + kCrumpledShare / kCrumpledRange);
  }
  return out;
}

// Log of the density of a stretch that is loose or tight over that of a tight one. `deviation`: the
// stretch as the prior's standard normal variable.
double log_loose_or_tight(const StretchPrior& prior, double deviation, double stretch) {
  if (prior.tight >= 1) return 0;
  const double tight = std::max(normal_density(deviation, 1) / (prior.spread * stretch), 1e-200);
  const double loose = 2 * normal_density(stretch, kLooseStretch);
  return std::log(prior.tight + (1 - prior.tight) * loose / tight);
}

}  // namespace

std::vector<Stretch> explain_bands(const HoopFamily& family,
                                   const std::vector<StretchPrior>& priors, double cloth_error) {
  const std::size_t n = family.dimensions.size();
  if (priors.size() != n) throw InvalidInput("explain_bands: not one prior per dimension");
  const auto stretch_of = [&](const std::vector<double>& draw, std::size_t d) {
    return priors[d].median * std::exp(priors[d].spread * draw[d]);
  };
  const auto likelihood = [&](const std::vector<double>& draw) {
    std::vector<double> stretch;
    double out = 0;
    for (std::size_t d = 0; d < n; ++d) {
      stretch.push_back(stretch_of(draw, d));
      out += log_loose_or_tight(priors[d], draw[d], stretch.back());
    }
    return out + log_likelihood(family, stretch, kCommonError * draw[n], cloth_error);
  };
  const std::vector<std::vector<double>> draws = posterior_sample(n + 1, likelihood);
  const auto count = static_cast<double>(draws.size());
  std::vector<Stretch> out;
  for (std::size_t d = 0; d < n; ++d) {
    double first = 0, second = 0;
    for (const std::vector<double>& draw : draws) {
      const double stretch = std::expm1(stretch_of(draw, d));
      first += stretch / count;
      second += stretch * stretch / count;
    }
    out.push_back({first, std::sqrt(std::max(0.0, second - first * first))});
  }
  return out;
}

}  // namespace regarment
