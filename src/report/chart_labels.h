#pragma once

#include <string>
#include <vector>

namespace regarment {

/// A few signs at the end of a line.
struct ChartLabel {
  double x = 0, y = 0;  // its left end and its base line
  std::string text;
  int style = 0;
};

/// Moves labels that would cover each other apart, up and down, as little as order and the ends
/// `top` and `bottom` of their base lines allow. Sorts them from top to bottom.
void spread_labels(std::vector<ChartLabel>& labels, double top, double bottom);

}  // namespace regarment
