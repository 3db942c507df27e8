#pragma once

#include <functional>
#include <string_view>

namespace regarment {

/// Told after each step of a long stage; answers "stop" by returning false.
/// `stage` is a short name for a person ("read", "measure"); `fraction` runs from 0 to 1 in a
/// stage.
using ProgressCallback = std::function<bool(std::string_view stage, double fraction)>;

/// The same with a line for a person on how the stage goes ("run 2, evaluation 40 of 500"), empty
/// when there is nothing to say.
using DetailedCallback =
    std::function<bool(std::string_view stage, double fraction, std::string_view detail)>;

/// Passes progress down through the stages. Copyable, cheap, safe to use from the calling thread
/// only. A default-constructed Progress says nothing and never stops.
class Progress {
 public:
  Progress() = default;
  explicit Progress(ProgressCallback callback);
  explicit Progress(DetailedCallback callback) : callback_(std::move(callback)) {}

  /// Throws Stopped when the callback answers "stop".
  void report(std::string_view stage, double fraction, std::string_view detail = {}) const;

 private:
  DetailedCallback callback_;
};

}  // namespace regarment
