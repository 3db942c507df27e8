#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace regarment {

/// Keeps a number of worker processes running: one that ends is started again, after a pause that
/// doubles while it keeps ending at once. They are politer than the server (nice), and end with it
/// however it ends. One thread.
class WorkerProcesses {
 public:
  /// `command`: absolute path of a program, then its arguments. `count` may be 0.
  WorkerProcesses(std::vector<std::string> command, int count);
  /// Kills what is left.
  ~WorkerProcesses();
  WorkerProcesses(const WorkerProcesses&) = delete;
  WorkerProcesses& operator=(const WorkerProcesses&) = delete;

  /// Starts what should run and does not; call it a few times a second. How many were found ended.
  int look_after();
  /// Asks all to end (SIGTERM); no more are started.
  void ask_to_end();
  /// Waits until all have ended, at most so long. False: some have not.
  bool wait(std::chrono::milliseconds most);
  std::vector<pid_t> running() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Place {
    pid_t process = -1;
    Clock::time_point started, again;  // `again`: not before
    std::chrono::milliseconds pause{0};
  };

  bool reap(Place& place) const;
  void start(Place& place);

  std::vector<std::string> command_;
  std::vector<Place> places_;
  bool ending_ = false;
};

}  // namespace regarment
