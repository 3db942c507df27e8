#include "scan/sandbox.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <memory>
#include <new>
#include <thread>

#include "base/error.h"

namespace regarment::test {
namespace {

using Kind = SandboxEnd::Kind;

SandboxEnd run(const std::function<void()>& work, const SandboxLimits& limits = {}) {
  return run_sandboxed(work, limits, Progress(), [] {});
}

// What a child leaves for us, at the start of shared memory.
template <class Value>
Value& shared(const SharedMemory& memory) {
  return *reinterpret_cast<Value*>(memory.span().data());
}

[[noreturn]] void compute_for_ever() {
  for (std::atomic<unsigned> n = 0;; ++n) {
  }
}

bool has_no_children() { return waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

TEST(Sandbox, ResultsComeBackThroughSharedMemory) {
  const SharedMemory memory(sizeof(int));
  int here = 0;
  const SandboxEnd end =
      run_sandboxed([&] { shared<int>(memory) = here = 42; }, {}, Progress(), [&] { here = 1; });
  EXPECT_EQ(end.kind, Kind::Finished);
  EXPECT_EQ(shared<int>(memory), 42);
  EXPECT_EQ(here, 1) << "the child has a copy of everything else";
  EXPECT_TRUE(has_no_children());
}

TEST(Sandbox, NothingButMemoryCanBeTouched) {
  if (!sandbox_is_closed()) GTEST_SKIP() << "sanitizers need an open sandbox";
  struct Errors {
    int open, read, write, socket, fork, exec, map;
  };
  const SharedMemory memory(sizeof(Errors));
  const auto failure = [](long result) { return result < 0 ? errno : 0; };
  const SandboxEnd end = run([&] {
    auto& errors = shared<Errors>(memory);
    char byte = 0;
    char* const none[] = {nullptr};
    errors.open = failure(open("/dev/null", O_RDONLY));
    errors.read = failure(read(STDIN_FILENO, &byte, 1));
    errors.write = failure(write(STDOUT_FILENO, &byte, 1));
    errors.socket = failure(socket(AF_INET, SOCK_STREAM, 0));
    errors.fork = failure(fork());
    errors.exec = failure(execv("/bin/true", none));
    void* const page = mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE, STDIN_FILENO, 0);
    errors.map = failure(page == MAP_FAILED ? -1 : 0);
  });
  EXPECT_EQ(end.kind, Kind::Finished);
  const auto& errors = shared<Errors>(memory);
  for (const int error : {errors.open, errors.read, errors.write, errors.socket, errors.fork,
                          errors.exec, errors.map}) {
    EXPECT_EQ(error, EPERM);
  }
}

TEST(Sandbox, MemoryIsLimited) {
  if (!sandbox_is_closed()) GTEST_SKIP() << "sanitizers need an open sandbox";
  const SharedMemory memory(2 * sizeof(int));
  const auto fails = [](std::size_t bytes) {
    const std::unique_ptr<char[]> taken(new (std::nothrow) char[bytes]);
    return taken == nullptr ? 1 : 2;
  };
  const SandboxEnd end = run(
      [&] {
        shared<std::array<int, 2>>(memory) = {fails(std::size_t{16} << 20U),
                                              fails(std::size_t{128} << 20U)};
      },
      {.memory = std::uint64_t{64} << 20U});
  EXPECT_EQ(end.kind, Kind::Finished);
  EXPECT_EQ((shared<std::array<int, 2>>(memory)), (std::array<int, 2>{2, 1}));
}

TEST(Sandbox, ComputingForEverEnds) {
  EXPECT_EQ(run(compute_for_ever, {.cpu_seconds = 1}).kind, Kind::CpuLimit);
  EXPECT_TRUE(has_no_children());
}

TEST(Sandbox, WaitingForEverEnds) {
  // What a copied lock does: it sleeps on a futex nobody wakes.
  const auto wait = [] { std::atomic<int>(0).wait(0); };
  EXPECT_EQ(run(wait, {.cpu_seconds = 3, .clock_seconds = 0}).kind, Kind::TimeLimit);
  EXPECT_TRUE(has_no_children());
}

TEST(Sandbox, CrashesStayInside) {
  const SandboxEnd end = run([] { std::raise(SIGABRT); });
  EXPECT_EQ(end.kind, Kind::Signal);
  if (sandbox_is_closed()) {
    EXPECT_EQ(end.detail, "SIGABRT");
  }
  const SandboxEnd fault = run([] { std::raise(SIGSEGV); });
  EXPECT_EQ(fault.kind, Kind::Signal);
}

TEST(Sandbox, StoppingEndsTheChild) {
  int asked = 0;
  const Progress stop_when_asked_twice([&](std::string_view, double) { return ++asked < 2; });
  EXPECT_THROW(run_sandboxed(compute_for_ever, {}, stop_when_asked_twice, [] {}), Stopped);
  EXPECT_EQ(asked, 2);
  EXPECT_TRUE(has_no_children());
}

// A terminal sends Ctrl-C to both. The parent decides; the child neither dies nor handles it.
TEST(Sandbox, SignalsToTheGroupAreForTheParent) {
  const SharedMemory memory(2 * sizeof(std::atomic<int>));
  static std::atomic<int>* handled = nullptr;
  handled = &shared<std::atomic<int>>(memory);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    auto* const before = std::signal(number, [](int) { ++*handled; });
    handled[1] = 0;
    const SandboxEnd end = run([number] {
      std::raise(number);
      handled[1] = 1;
    });
    std::signal(number, before);
    EXPECT_EQ(end.kind, Kind::Finished);
    EXPECT_EQ(handled[0].load(), 0);
    EXPECT_EQ(handled[1].load(), 1);
  }
}

// As the reaper of orphans this process inherits the child when the process between them is killed.
TEST(Sandbox, TheChildDiesWithItsParent) {
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  const SharedMemory memory(sizeof(std::atomic<pid_t>));
  auto& child = shared<std::atomic<pid_t>>(memory);
  const pid_t between = fork();
  if (between == 0) {
    run(
        [&] {
          child = getpid();
          compute_for_ever();
        },
        {.cpu_seconds = 60});
    _exit(0);
  }
  while (child == 0) std::this_thread::yield();
  kill(between, SIGKILL);
  int status = 0;
  ASSERT_EQ(waitpid(between, nullptr, 0), between);
  ASSERT_EQ(waitpid(child, &status, 0), child.load());
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
}  // namespace regarment::test
