#include "report/chart_dots.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

void add_extremes(const std::vector<double>& values, const std::vector<std::size_t>& stretch,
                  std::vector<std::size_t>& out) {
  const auto [least, most] =
      std::minmax_element(stretch.begin(), stretch.end(),
                          [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  out.push_back(std::min(*least, *most));
  if (*least != *most) out.push_back(std::max(*least, *most));
}

}  // namespace

std::vector<std::size_t> dots_to_draw(const std::vector<double>& values, std::size_t most) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) numbers.push_back(i);
  }
  if (numbers.size() <= most) return numbers;
  const std::size_t stretches = std::max<std::size_t>(most / 2, 1);
  std::vector<std::size_t> out;
  for (std::size_t s = 0; s < stretches; ++s) {
    const auto from = numbers.begin() + static_cast<long>(s * numbers.size() / stretches);
    const auto to = numbers.begin() + static_cast<long>((s + 1) * numbers.size() / stretches);
    if (from != to) add_extremes(values, {from, to}, out);
  }
  return out;
}

}  // namespace regarment
