#include "run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <sstream>
#include <stdexcept>

#include "base/under_sanitizer.h"

namespace regarment {
namespace {

constexpr rlim_t kAddressSpace = rlim_t{1} << 30;
constexpr int kSlowdown = kUnderSanitizer ? 6 : 1;  // what a sanitizer costs at worst

std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return ends;
}

// Only calls that are safe between fork and exec.
[[noreturn]] void become_program(char* const* argv, int out, int err, int seconds) {
  const rlimit space{kAddressSpace, kAddressSpace};
  if (!kUnderSanitizer) ::setrlimit(RLIMIT_AS, &space);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  // An alarm outlives exec, and SIGALRM ends a program that does not expect it.
  ::alarm(static_cast<unsigned>(seconds * kSlowdown));
  ::execv(argv[0], argv);
  ::_exit(127);
}

}  // namespace

RunningProgram::RunningProgram(const Arguments& arguments, int seconds) {
  std::vector<std::string> words = {REGARMENT_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const auto out = make_pipe(), err = make_pipe();
  child_ = ::fork();
  if (child_ < 0) throw std::runtime_error("no child");
  if (child_ == 0) become_program(argv.data(), out[1], err[1], seconds);
  ::close(out[1]);
  ::close(err[1]);
  out_ = out[0];
  err_ = err[0];
}

RunningProgram::~RunningProgram() {
  if (child_ > 0) {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  for (const int end : {out_, err_}) {
    if (end >= 0) ::close(end);
  }
}

bool RunningProgram::read_some() {
  std::array<pollfd, 2> ends = {pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
  if (out_ < 0 && err_ < 0) return false;
  ::poll(ends.data(), ends.size(), -1);
  const auto take = [](const pollfd& end, int& descriptor, std::string& text) {
    if (descriptor < 0 || end.revents == 0) return;
    std::array<char, 4096> block;
    const ssize_t got = ::read(descriptor, block.data(), block.size());
    if (got > 0) {
      text.append(block.data(), static_cast<std::size_t>(got));
      return;
    }
    ::close(descriptor);
    descriptor = -1;
  };
  take(ends[0], out_, run_.out);
  take(ends[1], err_, run_.err);
  return true;
}

bool RunningProgram::wait_for_line(const std::string& line) {
  do {
    if (("\n" + run_.err).find("\n" + line + "\n") != std::string::npos) return true;
  } while (read_some());
  return false;
}

void RunningProgram::send(int signal) const { ::kill(child_, signal); }

ProgramRun RunningProgram::finish() {
  while (read_some()) {
  }
  int status = 0;
  ::waitpid(child_, &status, 0);
  child_ = -1;
  run_.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  return run_;
}

ProgramRun run_program(const Arguments& arguments, int seconds) {
  return RunningProgram(arguments, seconds).finish();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(REGARMENT_SOURCE) / "examples/data" / name;
}

}  // namespace regarment
