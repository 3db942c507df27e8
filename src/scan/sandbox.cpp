#include "scan/sandbox.h"

#include <fcntl.h>
#include <poll.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>

#include "base/error.h"
#include "base/under_sanitizer.h"

namespace regarment {
namespace {

constexpr unsigned kSlowdown = kUnderSanitizer ? 10 : 1;
constexpr int kFinished = 0, kNotStarted = 100;  // exit statuses of the child
constexpr int kAskEvery = 100;                   // ms, between two looks at progress

// Address space this process has mapped, bytes; 0 when the system does not tell.
std::uint64_t mapped_bytes() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

// Lowers a limit, never raises it.
bool limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  struct rlimit current {};
  if (getrlimit(resource, &current) != 0) return false;
  current.rlim_max = std::min(current.rlim_max, hard);
  current.rlim_cur = std::min(current.rlim_max, soft);
  return setrlimit(resource, &current) == 0;
}

bool set_limits(const SandboxLimits& limits, std::uint64_t mapped) {
  const rlim_t seconds = rlim_t{limits.cpu_seconds} * kSlowdown;
  return limit(RLIMIT_CPU, seconds, seconds + 1) && limit(RLIMIT_FSIZE, 0, 0) &&
         limit(RLIMIT_CORE, 0, 0) && limit(RLIMIT_NPROC, 0, 0) &&
         (kUnderSanitizer || mapped == 0 ||
          limit(RLIMIT_AS, mapped + limits.memory, mapped + limits.memory));
}

// Everything but computing, memory and ending answers EPERM. Not even reading is needed: the input
// is in memory already and the result goes into shared memory.
bool set_filter() {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  if (kUnderSanitizer) return true;
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (filter == nullptr) return false;
  for (const int call :
       {SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(mprotect), SCMP_SYS(madvise),
        SCMP_SYS(futex), SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(rt_sigreturn),
        SCMP_SYS(rt_sigprocmask), SCMP_SYS(clock_gettime), SCMP_SYS(getrandom), SCMP_SYS(getpid),
        SCMP_SYS(gettid), SCMP_SYS(tgkill)}) {
    if (seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) != 0) return false;
  }
  constexpr unsigned kFlags = 3;  // which argument of mmap they are
  const scmp_arg_cmp anonymous{kFlags, SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, MAP_ANONYMOUS};
  return seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(mmap), 1, anonymous) == 0 &&
         seccomp_load(filter) == 0;
}

// Our handlers must not run in the child. Ctrl-C reaches it too, but whether to stop is for us to
// say: a child that died of it would look like one that a file broke. A sanitizer keeps the signals
// it reports faults by.
void reset_signals() {
  for (int number = 1; number < NSIG; ++number) {
    const bool fault = number == SIGSEGV || number == SIGBUS || number == SIGFPE ||
                       number == SIGILL || number == SIGABRT;
    if (!(kUnderSanitizer && fault)) std::signal(number, SIG_DFL);
  }
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(number, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void run_child(const std::function<void()>& work, const SandboxLimits& limits,
                            std::uint64_t mapped, pid_t parent, int alive) {
  reset_signals();
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  if (getppid() != parent) _exit(kNotStarted);
  if (dup2(alive, STDIN_FILENO) < 0) _exit(kNotStarted);
  // Standard error stays open for a sanitizer's report.
  if (!kUnderSanitizer) close(STDERR_FILENO);
  close(STDOUT_FILENO);
  close_range(STDERR_FILENO + 1, ~0U, 0);
  if (!set_limits(limits, mapped) || !set_filter()) _exit(kNotStarted);
  work();
  _exit(kFinished);
}

// Owns the child: none is left behind whatever happens here.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ > 0) end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Ends it if it still runs; its wait status, or -1 where SIGCHLD is ignored and it is lost.
  int end() {
    kill(pid_, SIGKILL);
    return wait();
  }
  int wait() {
    int status = -1;
    while (waitpid(pid_, &status, 0) < 0) {
      if (errno != EINTR) return -1;
    }
    pid_ = 0;
    return status;
  }

 private:
  pid_t pid_;
};

SandboxEnd end_of(int status) {
  using Kind = SandboxEnd::Kind;
  if (status == -1 || (WIFEXITED(status) && WEXITSTATUS(status) == kFinished)) {
    return {Kind::Finished, ""};
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotStarted) {
    return {Kind::NotStarted, "the limits could not be set"};
  }
  if (!WIFSIGNALED(status)) return {Kind::Signal, "exit status " + std::to_string(status >> 8)};
  if (WTERMSIG(status) == SIGXCPU) return {Kind::CpuLimit, ""};
  if (WTERMSIG(status) == SIGKILL) return {Kind::Killed, ""};
  const char* name = sigabbrev_np(WTERMSIG(status));
  return {Kind::Signal, name != nullptr ? std::string("SIG") + name : "an unknown signal"};
}

struct Pipe {
  int ends[2] = {-1, -1};
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) close(end);
    }
  }
  void close_writer() {
    close(ends[1]);
    ends[1] = -1;
  }
};

}  // namespace

SharedMemory::SharedMemory(std::size_t bytes) : size_(bytes) {
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) {
    throw TemporaryError("no address space for " + std::to_string(bytes >> 20U) +
                         " MiB to read the scan into; raise the memory limit");
  }
  data_ = static_cast<std::byte*>(memory);
}

SharedMemory::~SharedMemory() { munmap(data_, size_); }

bool sandbox_is_closed() { return !kUnderSanitizer; }

SandboxEnd run_sandboxed(const std::function<void()>& work, const SandboxLimits& limits,
                         const Progress& progress, const std::function<void()>& meanwhile) {
  // The child holds the writing end: it hangs up when the child is gone.
  Pipe alive;
  if (pipe2(alive.ends, O_CLOEXEC) != 0) return {SandboxEnd::Kind::NotStarted, "no pipe"};
  const std::uint64_t mapped = mapped_bytes();
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) return {SandboxEnd::Kind::NotStarted, "no process"};
  if (pid == 0) run_child(work, limits, mapped, parent, alive.ends[1]);
  Child child(pid);
  alive.close_writer();
  meanwhile();

  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(limits.clock_seconds * kSlowdown);
  for (;;) {
    struct pollfd hang_up {
      alive.ends[0], POLLIN, 0
    };
    if (poll(&hang_up, 1, kAskEvery) > 0) return end_of(child.wait());
    progress.report("read", 0.5);
    if (Clock::now() > deadline) {
      child.end();
      return {SandboxEnd::Kind::TimeLimit, ""};
    }
  }
}

}  // namespace regarment
