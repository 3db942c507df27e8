#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace regarment {

/// The value below which `share` (0..1) of `values` lie; the nearest element, no interpolation, so
/// that quantile(-v, s) = -quantile(v, 1 - s). 0 for no values. Does not depend on their order.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const double last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The same of `value(item)` over all items.
template <typename Items, typename Value>
double quantile_of(const Items& items, double share, Value value) {
  std::vector<double> values;
  values.reserve(std::size(items));
  for (const auto& item : items) values.push_back(value(item));
  return quantile(std::move(values), share);
}

/// 0 below `low`, 1 above `high`, linear between.
inline double ramp(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

}  // namespace regarment
