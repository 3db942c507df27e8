#include "analysis/mixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kFurthest = 8;  // standard deviations
constexpr double kExact = 1e-6;  // m

double share_below(const std::vector<Outcome>& outcomes, double length) {
  double below = 0, all = 0;
  for (const Outcome& o : outcomes) {
    const double z = (length - o.mean) / o.standard_deviation;
    below += o.weight * std::erfc(-z / std::numbers::sqrt2) / 2;
    all += o.weight;
  }
  return below / all;
}

}  // namespace

double mixture_quantile(const std::vector<Outcome>& outcomes, double share) {
  if (outcomes.empty()) throw InvalidInput("mixture_quantile: no outcomes");
  if (!(share > 0 && share < 1))
    throw InvalidInput("mixture_quantile: share must lie between 0 and 1");
  double low = outcomes.front().mean, high = low;
  for (const Outcome& o : outcomes) {
    if (!(o.weight > 0 && o.standard_deviation > 0 && std::isfinite(o.mean) &&
          std::isfinite(o.weight) && std::isfinite(o.standard_deviation)))
      throw InvalidInput("mixture_quantile: weights and deviations must be positive");
    low = std::min(low, o.mean - kFurthest * o.standard_deviation);
    high = std::max(high, o.mean + kFurthest * o.standard_deviation);
  }
  while (high - low > kExact) {
    const double middle = 0.5 * (low + high);
    (share_below(outcomes, middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace regarment
