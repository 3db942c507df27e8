#include "fit/weights.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/median.h"

namespace regarment {
namespace {

// Below these a term is as good as zero, and a weight made from it would be endless.
constexpr double kLeastDistance = 1e-5;  // m
constexpr double kLeastStretch = 0.01;   // of |1 - E_stretch|
constexpr double kLeastSilhouette = 0.01;

}  // namespace

ErrorWeights balance(std::span<const ErrorTerms> samples, bool square_root) {
  if (samples.empty()) throw InvalidInput("balance: no samples of the error terms");
  std::vector<double> distance, stretch, silhouette;
  for (const ErrorTerms& terms : samples) {
    distance.push_back(terms.distance);
    stretch.push_back(std::abs(1 - terms.stretch));
    silhouette.push_back(terms.silhouette);
  }
  const double size = std::max(median(distance), kLeastDistance);
  const double off = std::max(median(stretch), kLeastStretch);
  return {1.0, size / (square_root ? std::sqrt(off) : off),
          size / std::max(median(silhouette), kLeastSilhouette)};
}

}  // namespace regarment
