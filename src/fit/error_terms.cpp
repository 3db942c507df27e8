#include "fit/error_terms.h"

#include <cmath>

#include "base/error.h"

namespace regarment {

double total_error(const ErrorTerms& terms, const ErrorWeights& weights, bool square_root) {
  const double off = std::abs(1 - terms.stretch);
  return weights.alpha * terms.distance + weights.beta * (square_root ? std::sqrt(off) : off) +
         weights.gamma * terms.silhouette;
}

double silhouette_error(std::span<const Silhouette> model, std::span<const Silhouette> garment) {
  if (model.size() != garment.size())
    throw InvalidInput("silhouette_error: " + std::to_string(model.size()) +
                       " sides of the model, " + std::to_string(garment.size()) +
                       " of the garment");
  double sum = 0;
  for (std::size_t side = 0; side < model.size(); ++side) {
    const auto& m = model[side].covered;
    const auto& g = garment[side].covered;
    if (m.size() != g.size())
      throw InvalidInput("silhouette_error: the masks of side " + std::to_string(side) +
                         " differ in size");
    std::size_t differing = 0, area = 0;
    for (std::size_t i = 0; i < m.size(); ++i) differing += m[i] != g[i], area += g[i];
    if (area == 0)
      throw NoGarmentError(
          "the garment's silhouette is empty: it lies outside of the pictures; "
          "check the scan's units and axes");
    sum += static_cast<double>(differing) / static_cast<double>(area);
  }
  return sum;
}

double unseen_error(std::span<const Silhouette> model) {
  double sum = 0;
  for (const Silhouette& side : model) sum += static_cast<double>(side.area()) + 1;
  return sum;
}

}  // namespace regarment
