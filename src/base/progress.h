#pragma once

#include <functional>
#include <string_view>

namespace regarment {

/// Told after each step of a long stage; answers "stop" by returning false.
/// `stage` is a short name for a person ("read", "measure"); `fraction` runs from 0 to 1 in a
/// stage.
using ProgressCallback = std::function<bool(std::string_view stage, double fraction)>;

/// Passes progress down through the stages. Copyable, cheap, safe to use from the calling thread
/// only. A default-constructed Progress says nothing and never stops.
class Progress {
 public:
  Progress() = default;
  explicit Progress(ProgressCallback callback) : callback_(std::move(callback)) {}

  /// Throws Stopped when the callback answers "stop".
  void report(std::string_view stage, double fraction) const;

 private:
  ProgressCallback callback_;
};

}  // namespace regarment
