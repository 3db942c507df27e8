#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"

namespace regarment {

/// Tells the progress of searches that go on in other threads, and carries a "stop" to them.
class RunMonitor {
 public:
  RunMonitor(int runs, int evaluations_per_run);

  /// From the thread of run `run`, after each of its evaluations. Throws Stopped when the search is
  /// to end.
  void evaluated(int run, int evaluation, double best);
  /// From the thread of run `run`, when it is over, whatever its end.
  void finished(int run);

  /// In the thread of the caller: reports until all runs are over. When progress throws, all runs
  /// are asked to stop, waited for, and the exception goes on.
  void watch(const Progress& progress);

 private:
  struct State {
    int evaluation = 0;
    double best = 0;
    bool over = false;
  };
  bool all_over() const;
  void report(const Progress& progress) const;

  const int evaluations_per_run_;
  std::mutex guard_;
  std::condition_variable changed_;
  std::vector<State> runs_;  // guarded by guard_
  int latest_ = 0;           // the run that spoke last
  std::atomic<bool> stop_{false};
  Stopwatch clock_;
};

}  // namespace regarment
