#pragma once

#include <chrono>
#include <thread>

namespace regarment {

/// Turns SIGINT and SIGTERM into a question the program asks between two steps. While one stands,
/// a thread of its own waits for these signals; should the program not have ended two seconds (or
/// what `allow` says) after one came, the thread ends it with the status the signal asks for (130
/// or 143). SIGPIPE is ignored, so a reader that goes away is a write that fails. One per program,
/// made in `main` before any other thread.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// Whether a signal asked the program to stop. Any thread.
  bool asked() const;
  /// 130 for SIGINT, 143 for SIGTERM, 0 when neither came.
  int exit_status() const;

  /// How long the program may take to end by itself once it was asked to. Any thread.
  void allow(std::chrono::milliseconds time) const;

  /// Says once on standard error which signal stopped the program, and returns exit_status().
  int tell() const;

 private:
  std::thread watcher_;
};

}  // namespace regarment
