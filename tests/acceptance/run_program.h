#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace regarment {

using Arguments = std::vector<std::string>;

/// What a run of the program came to.
struct ProgramRun {
  int status = 0;        // exit status; 1000 + signal when a signal ended it
  std::string out, err;  // standard output and standard error
};

/// The program running as a child, with 1 GiB of address space (without limit under a sanitizer,
/// which needs more) and an end after `seconds` (SIGALRM, so status 1014).
class RunningProgram {
 public:
  explicit RunningProgram(const Arguments& arguments, int seconds = 5);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Reads standard error until a whole line `line` was seen; false when it ends before.
  bool wait_for_line(const std::string& line);
  void send(int signal) const;
  ProgramRun finish();

 private:
  // Reads what is there from both pipes; false when both have ended.
  bool read_some();

  pid_t child_ = -1;
  int out_ = -1, err_ = -1;
  ProgramRun run_;
};

/// Runs the program to its end.
ProgramRun run_program(const Arguments& arguments, int seconds = 5);

/// Lines of a text; an unfinished last line counts.
std::vector<std::string> lines_of(const std::string& text);

/// A file of examples/data.
std::filesystem::path example(const std::string& name);

/// How long a whole fit of an example may take, s: a limit against hanging, not a measure of speed.
inline constexpr int kFitSeconds = 120;

}  // namespace regarment
