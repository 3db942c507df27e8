#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench.h"

namespace regarment {

/// What a fit took.
struct FitTimes {
  double wall = 0, processor = 0;        // s
  std::map<std::string, double> stages;  // s
  std::optional<double> error_cm;        // mean over the dimensions whose truth is given
};

/// Runs the program as a process of its own, one at a time. Each call throws what a run that fails
/// says, and what `still_wanted` throws, which is called several times a second.
class FitTimer {
 public:
  FitTimer(const BenchOptions& options, std::function<void()> still_wanted)
      : options_(options), still_wanted_(std::move(still_wanted)) {}

  /// Fits a scan; the result is in `options.work`, in place of the last one.
  FitTimes fit(const BenchScan& scan, const std::string& method) const;
  /// Fits again what fit() left, without any change: s of wall time.
  double refit() const;
  /// Starts the program for nothing but its version: s of wall time.
  double start() const;

 private:
  double run(std::vector<std::string> words) const;

  const BenchOptions& options_;
  std::function<void()> still_wanted_;
};

/// MiB of the largest of all processes that ran so far.
double largest_child();

}  // namespace regarment
