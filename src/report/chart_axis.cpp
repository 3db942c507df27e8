#include "report/chart_axis.h"

#include <algorithm>
#include <cmath>

#include "report/text.h"

namespace regarment {
namespace {

constexpr double kRoom = 0.06;            // of the range, beyond its smallest and largest value
constexpr double kLogarithmicFrom = 4.0;  // largest over smallest value

// The smallest of 1, 2, 5 times a power of ten that is not below `least`.
double nice_step(double least) {
  const double ten = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (least <= step * ten * (1.0 + 1e-9)) return step * ten;
  }
  return 10.0 * ten;
}

std::vector<double> multiples(const AxisRange& range, double step) {
  std::vector<double> ticks;
  for (double i = std::ceil(range.low / step - 1e-9); i * step <= range.high + 1e-9 * step; ++i) {
    ticks.push_back(i * step);
    if (ticks.size() > 100) break;  // a range narrower than what numbers can tell apart
  }
  return ticks;
}

// A step finer where a round one would leave fewer than three.
std::vector<double> linear_ticks(const AxisRange& range, int count) {
  const double step = nice_step((range.high - range.low) / count);
  std::vector<double> ticks = multiples(range, step);
  return ticks.size() >= 3 ? ticks : multiples(range, nice_step(0.3 * step));
}

// Powers of ten within the range, times each of these.
std::vector<double> decade_multiples(const AxisRange& range,
                                     std::initializer_list<double> factors) {
  std::vector<double> out;
  for (double e = std::floor(std::log10(range.low)); e <= std::log10(range.high); ++e) {
    for (const double factor : factors) {
      const double tick = factor * std::pow(10.0, e);
      if (tick < range.low * (1 - 1e-9) || tick > range.high * (1 + 1e-9)) continue;
      out.push_back(tick);
    }
  }
  return out;
}

// As fine as leaves about `count` of them.
std::vector<double> logarithmic_ticks(const AxisRange& range, int count) {
  const std::vector<double> fine = decade_multiples(range, {1.0, 1.5, 2.0, 3.0, 5.0, 7.0});
  if (static_cast<int>(fine.size()) <= count + 1) return fine;
  const std::vector<double> medium = decade_multiples(range, {1.0, 2.0, 5.0});
  if (static_cast<int>(medium.size()) <= 2 * count) return medium;
  return decade_multiples(range, {1.0});
}

// Two digits at most, and no zero that says nothing: "0.015", "0.02", "3".
std::string logarithmic_text(double tick) {
  std::string text = significant_text(tick, 2);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

// Decimals that show all of these in full.
int digits_for(const std::vector<double>& ticks) {
  double largest = 0.0;
  for (const double tick : ticks) largest = std::max(largest, std::abs(tick));
  int digits = 0;
  for (const double tick : ticks) {
    const auto rest = [&] { return std::abs(std::remainder(tick, std::pow(10.0, -digits))); };
    while (digits < 9 && rest() > 1e-9 * largest) ++digits;
  }
  return digits;
}

void drop_nan(std::vector<double>& values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
}

}  // namespace

double AxisRange::share(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(std::max(value, 1e-300) / low) / std::log(high / low);
}

std::vector<AxisTick> axis_ticks(const AxisRange& range, int count) {
  const std::vector<double> values =
      range.logarithmic ? logarithmic_ticks(range, count) : linear_ticks(range, count);
  const int digits = digits_for(values);
  std::vector<AxisTick> ticks;
  for (const double value : values) {
    std::string text = range.logarithmic ? logarithmic_text(value) : fixed_text(value, digits);
    if (text.starts_with('-')) text.replace(0, 1, "\u2212");
    ticks.push_back({value, text});
  }
  return ticks;
}

AxisRange range_showing(std::vector<double> always, std::vector<double> mostly, double share,
                        AxisKind kind) {
  drop_nan(always);
  drop_nan(mostly);
  std::sort(mostly.begin(), mostly.end());
  if (!mostly.empty()) {
    const double cut = (1.0 - share) / 2.0 * static_cast<double>(mostly.size() - 1);
    const auto i = static_cast<std::size_t>(std::ceil(cut));
    always.push_back(mostly[i]);
    always.push_back(mostly[mostly.size() - 1 - i]);
  }
  if (always.empty()) return {};
  const auto [least, most] = std::minmax_element(always.begin(), always.end());
  const double low = *least, high = *most, room = kRoom * (high - low);
  if (high - low < 1e-9 * std::max(1.0, std::abs(high))) return {low - 0.5, high + 0.5};
  if (kind == AxisKind::Fitting && low > 0.0 && high / low > kLogarithmicFrom) {
    const double factor = std::pow(high / low, kRoom);
    return {low / factor, high * factor, true};
  }
  return {low - room, high + room};
}

}  // namespace regarment
