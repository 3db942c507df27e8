#pragma once

#include <optional>
#include <vector>

#include "analysis/analysis.h"

namespace regarment {

/// A garment that fits well lies this near to 95 % of its scan, mm. Folds and the cloth's own
/// thickness lie within.
inline constexpr double kDeviationBand = 5.0;

/// How far the scan lies from one draped garment. Signed: positive where the scan is outside of the
/// garment.
struct ResultDeviation {
  std::size_t vertices = 0;         // of the scan that have a deviation, >= 1
  double median_mm = 0;             // of the signed deviation
  double p95_mm = 0;                // 95 % of the vertices are at most this far off, either way
  double band_mm = 5;               // what a good fit keeps, see kDeviationBand
  std::size_t within = 0;           // vertices at most band_mm off, either way
  double range_mm = 1;              // the colour scale and the histogram go from -range to +range
  std::size_t below = 0;            // vertices below -range
  std::vector<std::size_t> counts;  // of equal bins over the range, lowest first; a bin holds its
                                    // lower end, the last one both
  std::size_t above = 0;            // vertices above +range
};

/// The deviation of every vertex of the scan, m: that of the outermost garment that has one, NaN
/// where none has. Empty when no garment has any. Throws InvalidInput when a garment's deviation
/// does not have one entry per vertex.
std::vector<float> merged_deviation(const Analysis& analysis);

/// The range of the colour scale for these values, m: one for all garments of an analysis.
double deviation_range(const std::vector<float>& merged);

/// In figures, for a scale of +-`range` metres. Nothing when no value is a number.
std::optional<ResultDeviation> summarize_deviation(const std::vector<float>& values, double range);

}  // namespace regarment
