#include "measure/covered_edge.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr int kCoveredRows = 8;  // of a map, from an edge to the garment that hides it
constexpr double kMostColumns = 0.5;

/// Share of columns in which an outer garment was taken close to the edge, beyond it or on its own
/// side.
double covered_share(const LimbView& view, const LimbMap& taken, const GarmentEdge& edge,
                     bool beyond) {
  int covered = 0;
  for (int j = 0; j < view.map.columns; ++j) {
    const int row = static_cast<int>(std::lround(view.map.row_of(edge.found.s[j])));
    for (int k = 0; k < kCoveredRows; ++k) {
      const int i = edge.garment_above == beyond ? row - k : row + 1 + k;
      if (i < 0 || i >= view.map.rows || !taken.has(i, j)) continue;
      ++covered;
      break;
    }
  }
  return static_cast<double>(covered) / view.map.columns;
}

/// Moves an edge, on whose own side an outer garment lies, to where that one ends: beyond it the
/// garment is hidden, and what looked like its edge was the outer one's.
void cut_off(const LimbView& view, const LimbMap& taken, GarmentEdge& edge) {
  const int way = edge.garment_above ? 1 : -1;
  for (int j = 0; j < view.map.columns; ++j) {
    int row = static_cast<int>(std::lround(view.map.row_of(edge.found.s[j])));
    int last = row;
    for (int gap = 0; gap < kCoveredRows && row >= 0 && row < view.map.rows; row += way) {
      gap = taken.has(row, j) ? 0 : gap + 1;
      if (gap == 0) last = row;
    }
    edge.found.s[j] = view.map.row_s(last);
    const int own = std::clamp(last + way, 0, view.map.rows - 1);
    if (view.map.has(own, j)) edge.found.r[j] = view.map.radius[view.map.index(own, j)];
  }
}

}  // namespace

void cut_off_where_covered(const LimbView& view, const LimbMap& taken, GarmentEdge& edge) {
  if (covered_share(view, taken, edge, false) > kMostColumns) cut_off(view, taken, edge);
  edge.covered = covered_share(view, taken, edge, true) > kMostColumns;
}

}  // namespace regarment
