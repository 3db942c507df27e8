#pragma once

#include <string>
#include <vector>

namespace regarment {

/// The values an axis spans, and how.
struct AxisRange {
  double low = 0, high = 1;  // low < high; both > 0 when logarithmic
  bool logarithmic = false;

  /// Where a value lies: 0 at `low`, 1 at `high`. Values beyond the ends stay beyond.
  double share(double value) const;
};

struct AxisTick {
  double value = 0;
  std::string text;  // the minus as U+2212
};

/// About `count` (>= 2) ticks within the range. On a linear axis they stand a step of 1, 2 or 5
/// times a power of ten apart and all have as many digits as tell them apart; on a logarithmic one
/// they are 1, 2 or 5 times a power of ten, or more or fewer steps where that suits the range.
std::vector<AxisTick> axis_ticks(const AxisRange& range, int count);

/// Whether an axis must be linear, or is logarithmic where all is positive and the largest value
/// more than four times the smallest.
enum class AxisKind { Linear, Fitting };

/// A range that shows all of `always` and `share` (0..1) of `mostly`, cut at both ends alike, with
/// a little room; NaN is left out. One wide when all values are the same; 0 to 1 for none.
AxisRange range_showing(std::vector<double> always, std::vector<double> mostly, double share,
                        AxisKind kind = AxisKind::Linear);

}  // namespace regarment
