#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace regarment {

/// How a child process ended.
struct ChildEnd {
  int status = 0;          // exit status; 128 + signal when a signal ended it
  int signal = 0;          // that ended it; 0: none did
  bool timed_out = false;  // ended by us, its time was over
  std::string last_line;   // of standard error; what was not printable is spelled out
  double seconds = 0;      // wall time
};

/// What a child may use up; 0: as much as we may ourselves.
struct ChildLimits {
  std::chrono::milliseconds time{0};  // wall time; then SIGTERM, and SIGKILL a second later
  std::uint64_t memory = 0;           // address space, bytes; as much as it likes under a sanitizer
  std::uint64_t file = 0;             // of any one file it writes, bytes; more is a failed write
};

/// A running child process in a process group of its own. Standard input and output are /dev/null,
/// standard error comes to us. It ends with the thread that began it, however that ends, and at the
/// latest when this is destroyed, together with all processes of its group. One thread at a time.
class ChildProcess {
 public:
  /// `command`: absolute path of a program, then its arguments. A program that cannot be run ends
  /// with status 127. Throws TemporaryError when no process can be started.
  explicit ChildProcess(const std::vector<std::string>& command, const ChildLimits& limits = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// To wait on with poll; -1 once the child has closed it.
  int output() const { return output_; }
  /// Sends a signal to its whole group.
  void signal(int number) const;
  /// Takes what it said, and sends what its time asks for; to be called several times a second.
  void look_after();
  /// The whole lines it said since the last call, without their ends. Of a flood only the last
  /// 64 KiB are kept.
  std::vector<std::string> take_lines();
  /// Whether it has ended; then all of its group has, and `end` says how.
  bool ended(ChildEnd& end);

 private:
  using Clock = std::chrono::steady_clock;

  void read_output();

  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> deadline_;
  pid_t pid_ = -1;
  int output_ = -1;
  bool timed_out_ = false;
  std::string text_;       // said and not taken
  std::string last_line_;  // the last one that was taken
};

/// Waits until one of them says something or ends, at most `most`.
void wait_for_children(const std::vector<const ChildProcess*>& children,
                       std::chrono::milliseconds most);

}  // namespace regarment
