#include "report/chart_labels.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr double kWide = 14.0, kHigh = 11.0;  // room for a number of two digits

bool one_above_the_other(const ChartLabel& a, const ChartLabel& b) {
  return std::abs(a.x - b.x) < kWide;
}

}  // namespace

void spread_labels(std::vector<ChartLabel>& labels, double top, double bottom) {
  std::stable_sort(labels.begin(), labels.end(),
                   [](const ChartLabel& a, const ChartLabel& b) { return a.y < b.y; });
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i].y = std::max(labels[i].y, top);
    for (std::size_t j = 0; j < i; ++j) {
      if (!one_above_the_other(labels[i], labels[j])) continue;
      labels[i].y = std::max(labels[i].y, labels[j].y + kHigh);
    }
  }
  for (std::size_t i = labels.size(); i-- > 0;) {
    labels[i].y = std::min(labels[i].y, bottom);
    for (std::size_t j = i + 1; j < labels.size(); ++j) {
      if (!one_above_the_other(labels[i], labels[j])) continue;
      labels[i].y = std::min(labels[i].y, labels[j].y - kHigh);
    }
  }
}

}  // namespace regarment
