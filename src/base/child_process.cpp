#include "base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "base/one_line.h"
#include "base/under_sanitizer.h"

namespace regarment {
namespace {

constexpr std::chrono::milliseconds kGrace{1000};    // between SIGTERM and SIGKILL
constexpr std::chrono::milliseconds kLastMoment{1};  // between a child's last word and its end
constexpr std::size_t kKeptText = 64U << 10U;        // of standard error; the last line is in it
constexpr std::size_t kLongestLine = 500;

/// What a child is given, ready before the fork.
struct Start {
  std::vector<char*> arguments;
  ChildLimits limits;
  int nothing = -1, output = -1;  // /dev/null; the pipe standard error goes to
  pid_t parent = 0;
};

void lower(__rlimit_resource resource, std::uint64_t most) {
  if (most == 0) return;
  struct rlimit limit {};
  ::getrlimit(resource, &limit);
  limit.rlim_max = std::min<rlim_t>(limit.rlim_max, most);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, most);
  ::setrlimit(resource, &limit);
}

// Between fork and exec: only what is safe there.
[[noreturn]] void become(const Start& start) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != start.parent) ::_exit(127);  // it went before we asked to be told
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  // Too long a file is then a write that fails, which the program can speak of.
  if (start.limits.file > 0) ::signal(SIGXFSZ, SIG_IGN);
  if (!kUnderSanitizer) lower(RLIMIT_AS, start.limits.memory);
  lower(RLIMIT_FSIZE, start.limits.file);
  ::dup2(start.nothing, STDIN_FILENO);
  ::dup2(start.nothing, STDOUT_FILENO);
  ::dup2(start.output, STDERR_FILENO);
  ::execv(start.arguments.front(), start.arguments.data());
  ::_exit(127);
}

[[noreturn]] void throw_not_started(int error) {
  throw TemporaryError(std::string("a fit cannot be started (") + std::strerror(error) +
                       "); run fewer at a time and try again");
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const ChildLimits& limits) {
  Start start;
  for (const std::string& word : command) {
    start.arguments.push_back(const_cast<char*>(word.c_str()));
  }
  start.arguments.push_back(nullptr);
  start.limits = limits;
  start.parent = ::getpid();
  std::array<int, 2> ends{-1, -1};
  start.nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  const bool ready = start.nothing >= 0 && ::pipe2(ends.data(), O_CLOEXEC) == 0;
  start.output = ends[1];
  if (ready) pid_ = ::fork();
  if (ready && pid_ == 0) become(start);
  const int error = errno;
  output_ = ends[0];
  if (start.nothing >= 0) ::close(start.nothing);
  if (ends[1] >= 0) ::close(ends[1]);
  if (pid_ < 0) {
    if (output_ >= 0) ::close(output_);
    throw_not_started(error);
  }
  ::setpgid(pid_, pid_);  // whoever of the two comes first
  ::fcntl(output_, F_SETFL, O_NONBLOCK);
  if (limits.time.count() > 0) deadline_ = start_ + limits.time;
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    signal(SIGKILL);
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  if (output_ >= 0) ::close(output_);
}

void ChildProcess::signal(int number) const {
  if (pid_ > 0) ::kill(-pid_, number);
}

void ChildProcess::look_after() {
  read_output();
  const auto now = Clock::now();
  if (!deadline_ || now < *deadline_) return;
  if (!timed_out_) signal(SIGTERM);
  timed_out_ = true;
  if (now >= *deadline_ + kGrace) signal(SIGKILL);
}

std::vector<std::string> ChildProcess::take_lines() {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text_.find_first_of("\r\n", begin)) != std::string::npos;) {
    if (end > begin) lines.push_back(text_.substr(begin, end - begin));
    begin = end + 1;
  }
  text_.erase(0, begin);
  if (!lines.empty()) last_line_ = lines.back();
  return lines;
}

bool ChildProcess::ended(ChildEnd& end) {
  siginfo_t seen{};
  const int how = WEXITED | WNOHANG | WNOWAIT;
  if (::waitid(P_PID, static_cast<id_t>(pid_), &seen, how) != 0 || seen.si_pid == 0) return false;
  read_output();
  signal(SIGKILL);  // what it left behind; its number is still taken, so no stranger is hit
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  end.timed_out = timed_out_;
  end.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if (!text_.empty() && text_.back() != '\n') text_ += '\n';
  const std::string kept = text_;
  take_lines();
  text_ = kept;  // still there for the caller
  end.last_line = one_line(last_line_, kLongestLine);
  return true;
}

void ChildProcess::read_output() {
  std::array<char, 4096> block;
  ssize_t got = 0;
  while (output_ >= 0 && (got = ::read(output_, block.data(), block.size())) > 0) {
    text_.append(block.data(), static_cast<std::size_t>(got));
    if (text_.size() > kKeptText) text_.erase(0, text_.size() - kKeptText);
  }
  // Closed by the child: nothing more to wait for but its end.
  if (got == 0 && output_ >= 0) ::close(std::exchange(output_, -1));
}

void wait_for_children(const std::vector<const ChildProcess*>& children,
                       std::chrono::milliseconds most) {
  std::vector<pollfd> watched;
  for (const ChildProcess* child : children) {
    if (child->output() >= 0) watched.push_back({child->output(), POLLIN, 0});
  }
  // One that has closed its output is on its way out, and nothing wakes us once it is there.
  if (watched.size() < children.size()) most = std::min(most, kLastMoment);
  ::poll(watched.data(), watched.size(), static_cast<int>(most.count()));
}

}  // namespace regarment
