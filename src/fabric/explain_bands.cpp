#include "fabric/explain_bands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/random.h"

namespace regarment {
namespace {

constexpr int kDraws = 20000;
// All strips of a fitted cloth may be longer by the noise of the scan, or shorter by folds that
// its triangles are too large for.
constexpr double kCommonError = 0.015;
constexpr double kModelError = 0.002;    // of a strain: what a flat pattern leaves out
constexpr double kGirthError = 0.003;    // m, of a strip's length on the fitted cloth
constexpr double kMostStrain = 0.1;      // of a strip that is tight; any up to it is as likely
constexpr double kLooseShare = 0.5;      // of strips, before they are looked at
constexpr double kCrumpledShare = 0.02;  // of strips whose triangles do not follow their folds
constexpr double kCrumpledRange = 0.4;   // over which their lengths are spread
// Strips closer than about 5 cm err alike, so each counts as less than one observation.
constexpr double kIndependence = 0.4;

double normal_density(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2 * std::numbers::pi));
}

// Density of a variable spread evenly from 0 to `most` plus a normal one, below `most`.
double tight_density(double x, double most, double sigma) {
  return 0.5 * std::erfc(-x / (sigma * std::numbers::sqrt2)) / most;
}

double log_likelihood(const HoopFamily& family, const std::vector<double>& stretch, double common) {
  double out = 0;
  for (const HoopBand& band : family.bands) {
    double strain = band.excess - common;
    for (std::size_t d = 0; d < stretch.size(); ++d) strain += band.share[d] * stretch[d];
    const double sigma = std::hypot(kModelError, kGirthError / band.girth);
    const double sound = kLooseShare * normal_density(strain, sigma) +
                         (1 - kLooseShare) * tight_density(strain, kMostStrain, sigma);
    out += kIndependence * std::log((1 - kCrumpledShare) * sound + kCrumpledShare / kCrumpledRange);
  }
  return out;
}

}  // namespace

std::vector<Stretch> explain_bands(const HoopFamily& family,
                                   const std::vector<StretchPrior>& priors) {
  const std::size_t n = family.dimensions.size();
  if (priors.size() != n) throw InvalidInput("explain_bands: not one prior per dimension");
  Random random(1);
  std::vector<std::vector<double>> draws;
  std::vector<double> weights;
  for (int k = 0; k < kDraws; ++k) {
    std::vector<double> stretch;
    for (const StretchPrior& prior : priors) {
      stretch.push_back(prior.median * std::exp(prior.spread * random.normal()));
    }
    weights.push_back(log_likelihood(family, stretch, kCommonError * random.normal()));
    draws.push_back(std::move(stretch));
  }
  const double best = *std::max_element(weights.begin(), weights.end());
  std::vector<double> first(n, 0.0), second(n, 0.0);
  double total = 0;
  for (std::size_t k = 0; k < draws.size(); ++k) {
    const double weight = std::exp(weights[k] - best);
    total += weight;
    for (std::size_t d = 0; d < n; ++d) {
      const double stretch = std::expm1(draws[k][d]);
      first[d] += weight * stretch;
      second[d] += weight * stretch * stretch;
    }
  }
  std::vector<Stretch> out(n);
  for (std::size_t d = 0; d < n; ++d) {
    out[d].mean = first[d] / total;
    out[d].standard_deviation =
        std::sqrt(std::max(0.0, second[d] / total - out[d].mean * out[d].mean));
  }
  return out;
}

}  // namespace regarment
