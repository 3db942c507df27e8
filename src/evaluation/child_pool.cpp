#include "evaluation/child_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollMilliseconds = 100;
constexpr std::chrono::milliseconds kGrace{1000};  // between SIGTERM and SIGKILL
constexpr std::size_t kKeptText = 8192;            // of standard error; the last line is in it

// Between fork and exec: only what is safe there. `output` is the pipe standard error goes to.
[[noreturn]] void become(const std::vector<char*>& arguments, int nothing, int output,
                         pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // it went before we asked to be told
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execv(arguments.front(), arguments.data());
  ::_exit(127);
}

/// A running child; gone, with all it began, at the latest when this is.
class Child {
 public:
  Child(std::size_t index, const std::vector<std::string>& command, Clock::duration timeout)
      : index_(index), start_(Clock::now()), deadline_(start_ + timeout) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nothing < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) fail(nothing);
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) become(arguments, nothing, ends[1], parent);
    output_ = ends[0];
    ::close(ends[1]);
    if (pid_ < 0) fail(nothing);
    ::close(nothing);
    ::setpgid(pid_, pid_);  // whoever of the two comes first
    ::fcntl(output_, F_SETFL, O_NONBLOCK);
  }
  ~Child() {
    if (pid_ > 0) {
      signal(SIGKILL);
      int status = 0;
      while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
      }
    }
    if (output_ >= 0) ::close(output_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::size_t index() const { return index_; }
  int output() const { return output_; }
  void signal(int number) const { ::kill(-pid_, number); }

  /// Takes what it said, and sends what its time asks for.
  void look_after() {
    read_output();
    const auto now = Clock::now();
    if (now < deadline_) return;
    if (!timed_out_) signal(SIGTERM);
    timed_out_ = true;
    if (now >= deadline_ + kGrace) signal(SIGKILL);
  }

  /// Whether it has ended; `end` says how.
  bool ended(ChildEnd& end) {
    siginfo_t seen{};
    const int how = WEXITED | WNOHANG | WNOWAIT;
    if (::waitid(P_PID, static_cast<id_t>(pid_), &seen, how) != 0 || seen.si_pid == 0) return false;
    read_output();
    signal(SIGKILL);  // what it left behind; its number is still taken, so no stranger is hit
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    end.timed_out = timed_out_;
    end.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    while (!text_.empty() && (text_.back() == '\n' || text_.back() == '\r')) text_.pop_back();
    end.last_line = one_line(text_.substr(text_.find_last_of("\r\n") + 1), 500);
    return true;
  }

 private:
  [[noreturn]] void fail(int nothing) {
    const int error = errno;
    if (nothing >= 0) ::close(nothing);
    if (output_ >= 0) ::close(std::exchange(output_, -1));
    throw TemporaryError(std::string("a fit cannot be started (") + std::strerror(error) +
                         "); try again with fewer --jobs");
  }

  void read_output() {
    std::array<char, 4096> block;
    ssize_t got = 0;
    while (output_ >= 0 && (got = ::read(output_, block.data(), block.size())) > 0) {
      text_.append(block.data(), static_cast<std::size_t>(got));
      if (text_.size() > kKeptText) text_.erase(0, text_.size() - kKeptText);
    }
    // Closed by the child: nothing more to wait for but its end.
    if (got == 0 && output_ >= 0) ::close(std::exchange(output_, -1));
  }

  std::size_t index_;
  Clock::time_point start_, deadline_;
  pid_t pid_ = -1;
  int output_ = -1;
  bool timed_out_ = false;
  std::string text_;
};

using Children = std::vector<std::unique_ptr<Child>>;

void wait_a_little(const Children& children) {
  std::vector<pollfd> watched;
  for (const auto& child : children) {
    if (child->output() >= 0) watched.push_back({child->output(), POLLIN, 0});
  }
  ::poll(watched.data(), watched.size(), kPollMilliseconds);
}

// All at once and politely, so that each can remove what is half written.
void stop(Children& children) {
  for (const auto& child : children) child->signal(SIGTERM);
  const auto patience = Clock::now() + kGrace;
  while (!children.empty() && Clock::now() < patience) {
    wait_a_little(children);
    std::erase_if(children, [](const auto& child) {
      ChildEnd ignored;
      child->look_after();
      return child->ended(ignored);
    });
  }
}

// Starts, tends and reaps until all commands have ended.
void run(const std::vector<std::vector<std::string>>& commands, const ChildPoolOptions& options,
         const std::function<void(std::size_t, const ChildEnd&)>& ended,
         const std::function<void()>& still_wanted, Children& children) {
  std::size_t next = 0;
  while (next < commands.size() || !children.empty()) {
    still_wanted();
    while (next < commands.size() && children.size() < static_cast<std::size_t>(options.at_once)) {
      children.push_back(std::make_unique<Child>(next, commands[next], options.timeout));
      ++next;
    }
    wait_a_little(children);
    for (std::size_t i = 0; i < children.size();) {
      ChildEnd end;
      children[i]->look_after();
      if (!children[i]->ended(end)) {
        ++i;
        continue;
      }
      const std::size_t index = children[i]->index();
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(i));
      ended(index, end);
    }
  }
}

}  // namespace

void run_children(const std::vector<std::vector<std::string>>& commands,
                  const ChildPoolOptions& options,
                  const std::function<void(std::size_t, const ChildEnd&)>& ended,
                  const std::function<void()>& still_wanted) {
  Children children;
  try {
    run(commands, options, ended, still_wanted, children);
  } catch (...) {
    stop(children);
    throw;
  }
}

}  // namespace regarment
