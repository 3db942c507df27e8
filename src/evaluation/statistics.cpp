#include "evaluation/statistics.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kNormal95 = 1.96;          // standard deviations on either side that hold 95 %
constexpr double kMissedShare = 0.1;        // of truths, outside of a 90 % interval
constexpr std::size_t kTruthsForSlope = 4;  // fewer say little about a slope

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double share_within(const std::vector<double>& sizes, double limit) {
  // A hundredth of a micrometre: 101.0 - 100.0 as read from text still counts as 1.
  const auto inside =
      std::count_if(sizes.begin(), sizes.end(), [&](double size) { return size <= limit + 1e-6; });
  return static_cast<double>(inside) / static_cast<double>(sizes.size());
}

std::optional<double> slope_of(const std::vector<Sample>& samples) {
  std::set<double> truths;
  std::vector<double> x, y;
  for (const Sample& sample : samples) {
    truths.insert(sample.truth);
    x.push_back(sample.truth), y.push_back(sample.estimate);
  }
  if (truths.size() < kTruthsForSlope) return std::nullopt;
  const double mean_x = mean_of(x), mean_y = mean_of(y);
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    xx += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return xy / xx;
}

void add_spread(const std::vector<double>& errors, ErrorStatistics& out) {
  if (errors.size() < 2) return;
  const double n = static_cast<double>(errors.size());
  double squares = 0;
  for (const double error : errors) squares += (error - out.bias_cm) * (error - out.bias_cm);
  out.sd_cm = std::sqrt(squares / (n - 1));
  const double half = kNormal95 * *out.sd_cm / std::sqrt(n);
  out.bias_low_cm = out.bias_cm - half;
  out.bias_high_cm = out.bias_cm + half;
}

void add_intervals(const std::vector<Sample>& samples, ErrorStatistics& out) {
  std::vector<double> widths, scores;
  std::size_t covered = 0;
  for (const Sample& sample : samples) {
    if (!sample.low || !sample.high) continue;
    widths.push_back(*sample.high - *sample.low);
    scores.push_back(interval_score(*sample.low, *sample.high, sample.truth));
    if (*sample.low <= sample.truth && sample.truth <= *sample.high) ++covered;
  }
  out.intervals = widths.size();
  if (widths.empty()) return;
  out.coverage = static_cast<double>(covered) / static_cast<double>(widths.size());
  out.median_width_cm = quantile(widths, 0.5);
  out.interval_score_cm = mean_of(scores);
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  if (values.empty()) throw InvalidInput("a quantile of nothing");
  std::sort(values.begin(), values.end());
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

double interval_score(double low, double high, double truth) {
  const double beyond = std::max({low - truth, truth - high, 0.0});
  return high - low + 2 / kMissedShare * beyond;
}

ErrorStatistics error_statistics(const std::vector<Sample>& samples) {
  ErrorStatistics out;
  out.n = samples.size();
  if (samples.empty()) return out;
  std::vector<double> errors, sizes, squares;
  for (const Sample& sample : samples) {
    const double error = sample.estimate - sample.truth;
    errors.push_back(error), sizes.push_back(std::abs(error)), squares.push_back(error * error);
    out.worst_cm = std::max(out.worst_cm, std::abs(error));
  }
  out.bias_cm = mean_of(errors);
  out.mae_cm = mean_of(sizes);
  out.rmse_cm = std::sqrt(mean_of(squares));
  out.median_cm = quantile(errors, 0.5);
  out.p95_cm = quantile(sizes, 0.95);
  out.within_1cm = share_within(sizes, 1);
  out.within_2cm = share_within(sizes, 2);
  out.slope = slope_of(samples);
  add_spread(errors, out);
  add_intervals(samples, out);
  return out;
}

}  // namespace regarment
