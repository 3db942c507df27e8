#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace regarment {

/// One dimension of one scan: what it is and what was found. Centimetres.
struct Sample {
  double truth = 0, estimate = 0;
  std::optional<double> low, high;  // 90 % interval; both or none
};

/// How far estimates are from the truth. An error is estimate - truth. What cannot be told from so
/// few samples is empty.
struct ErrorStatistics {
  std::size_t n = 0;
  double bias_cm = 0;    // mean error
  double mae_cm = 0;     // mean absolute error
  double rmse_cm = 0;    // root of the mean squared error
  double median_cm = 0;  // of the errors; the mean of the two in the middle where n is even
  double p95_cm = 0;     // of the absolute errors, between ranks as `quantile` says
  double worst_cm = 0;   // largest absolute error
  double within_1cm = 0, within_2cm = 0;            // shares, ends included
  std::optional<double> sd_cm;                      // of the errors, n - 1; n >= 2
  std::optional<double> bias_low_cm, bias_high_cm;  // 95 %: bias -+ 1.96 SD / sqrt(n); n >= 2
  std::optional<double> slope;                      // least squares, estimate on truth; needs
                                                    // four different truths
  std::size_t intervals = 0;                        // samples with an interval
  std::optional<double> coverage;                   // share of them that hold the truth
  std::optional<double> median_width_cm, interval_score_cm;  // see interval_score
};

/// An empty list gives n = 0 and zeros.
ErrorStatistics error_statistics(const std::vector<Sample>& samples);

/// The value below which `share` (0..1) of the values lie: on the straight line between the two
/// nearest ranks, rank 0 the smallest and rank n - 1 the largest value. `values` is not empty.
double quantile(std::vector<double> values, double share);

/// Winkler's score of a 90 % interval, the smaller the better: its width, and 20 times what the
/// truth lies beyond it [Gneiting and Raftery 2007, eq. (43)].
double interval_score(double low, double high, double truth);

}  // namespace regarment
