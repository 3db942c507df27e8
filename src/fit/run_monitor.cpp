#include "fit/run_monitor.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "base/error.h"

namespace regarment {

RunMonitor::RunMonitor(int runs, int evaluations_per_run)
    : evaluations_per_run_(evaluations_per_run), runs_(static_cast<std::size_t>(runs)) {}

void RunMonitor::evaluated(int run, int evaluation, double best) {
  {
    const std::lock_guard lock(guard_);
    State& state = runs_[static_cast<std::size_t>(run)];
    state.evaluation = evaluation, state.best = best;
    latest_ = run;
  }
  changed_.notify_one();
  if (stop_) throw Stopped();
}

void RunMonitor::finished(int run) {
  {
    const std::lock_guard lock(guard_);
    runs_[static_cast<std::size_t>(run)].over = true;
  }
  changed_.notify_one();
}

bool RunMonitor::all_over() const {
  return std::all_of(runs_.begin(), runs_.end(), [](const State& s) { return s.over; });
}

void RunMonitor::report(const Progress& progress) const {
  double done = 0, best = -1;
  for (const State& s : runs_) {
    done += s.over ? evaluations_per_run_ : s.evaluation;
    if (s.evaluation > 0 && (best < 0 || s.best < best)) best = s.best;
  }
  const double fraction =
      done / (static_cast<double>(runs_.size()) * static_cast<double>(evaluations_per_run_));
  if (best < 0) return progress.report("fit", 0.0);
  const double left = clock_.total() * (1 - fraction) / std::max(fraction, 1e-6);
  char text[160];
  std::snprintf(text, sizeof text,
                "run %d of %zu, evaluation %d of %d, best error %.5f, %.0f s left", latest_ + 1,
                runs_.size(), runs_[static_cast<std::size_t>(latest_)].evaluation,
                evaluations_per_run_, best, left);
  progress.report("fit", std::min(fraction, 0.999), text);
}

void RunMonitor::watch(const Progress& progress) {
  std::exception_ptr stopped;
  std::unique_lock lock(guard_);
  while (!all_over()) {
    changed_.wait(lock);
    if (stopped) continue;
    try {
      report(progress);
    } catch (...) {
      stopped = std::current_exception();
      stop_ = true;
    }
  }
  if (stopped) std::rethrow_exception(stopped);
}

}  // namespace regarment
