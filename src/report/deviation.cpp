#include "report/deviation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "render/heat_map.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr std::size_t kBins = 40;  // even, so that zero is an edge between two
constexpr double kMillimetres = 1000.0;
constexpr int kDigits = 3;  // of a millimetre

// The value below which `share` of the sorted values lie, linear between neighbours.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto i = static_cast<std::size_t>(place);
  if (i + 1 == sorted.size()) return sorted.back();
  return sorted[i] + (place - static_cast<double>(i)) * (sorted[i + 1] - sorted[i]);
}

double quantile_of_sizes(std::vector<double> values, double share) {
  for (double& value : values) value = std::abs(value);
  std::sort(values.begin(), values.end());
  return quantile(values, share);
}

void count(double value_mm, ResultDeviation& out) {
  // A hair of room: the values were floats of metres.
  const double end = 1.0 + 1e-6, at = value_mm / out.range_mm;
  if (at < -end) {
    ++out.below;
  } else if (at > end) {
    ++out.above;
  } else {
    const double place = (std::clamp(at, -1.0, 1.0) + 1.0) / 2.0 * double(kBins);
    ++out.counts[std::min(static_cast<std::size_t>(place), kBins - 1)];
  }
}

}  // namespace

std::vector<float> merged_deviation(const Analysis& analysis) {
  std::vector<float> merged;
  for (const GarmentAnalysis& garment : analysis.garments) {
    if (garment.deviation.empty()) continue;
    if (garment.deviation.size() != analysis.scan.mesh.positions.size()) {
      throw InvalidInput("a deviation must have one entry per vertex of the scan");
    }
    if (merged.empty()) {
      merged = garment.deviation;
      continue;
    }
    for (std::size_t i = 0; i < merged.size(); ++i) {
      if (std::isnan(merged[i])) merged[i] = garment.deviation[i];
    }
  }
  return merged;
}

double deviation_range(const std::vector<float>& merged) { return symmetric_range(merged); }

std::optional<ResultDeviation> summarize_deviation(const std::vector<float>& values, double range) {
  std::vector<double> sorted;
  for (const float value : values) {
    if (std::isinf(value)) throw InvalidInput("a deviation is not finite");
    if (!std::isnan(value)) sorted.push_back(double(value) * kMillimetres);
  }
  if (sorted.empty()) return std::nullopt;
  std::sort(sorted.begin(), sorted.end());
  ResultDeviation out;
  out.vertices = sorted.size();
  out.median_mm = rounded(quantile(sorted, 0.5), kDigits);
  out.p95_mm = rounded(quantile_of_sizes(sorted, 0.95), kDigits);
  out.band_mm = kDeviationBand;
  out.within =
      static_cast<std::size_t>(std::count_if(sorted.begin(), sorted.end(), [](double value) {
        return std::abs(value) <= kDeviationBand;
      }));
  out.range_mm = rounded_significant(range * kMillimetres, 6);
  out.counts.assign(kBins, 0);
  for (const double value : sorted) count(value, out);
  return out;
}

}  // namespace regarment
