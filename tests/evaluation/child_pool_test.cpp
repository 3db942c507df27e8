#include "evaluation/child_pool.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "base/error.h"
#include "support/folders.h"

namespace regarment {
namespace {

using Ends = std::map<std::size_t, ChildEnd>;

std::vector<std::string> shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

Ends run(const std::vector<std::vector<std::string>>& commands,
         const ChildPoolOptions& options = {}) {
  Ends ends;
  run_children(
      commands, options, [&](std::size_t i, const ChildEnd& end) { ends[i] = end; }, [] {});
  return ends;
}

TEST(ChildPool, TellsHowEachEnded) {
  const Ends ends = run({shell("exit 0"),
                         shell("echo first >&2; echo why >&2; exit 4"),
                         shell("kill -SEGV $$"),
                         {"/nowhere/at/all"}});
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_EQ(ends.at(0).status, 0);
  EXPECT_EQ(ends.at(0).last_line, "");
  EXPECT_EQ(ends.at(1).status, 4);
  EXPECT_EQ(ends.at(1).last_line, "why");
  EXPECT_EQ(ends.at(2).status, 128 + SIGSEGV);
  EXPECT_EQ(ends.at(3).status, 127);
}

TEST(ChildPool, KeepsTheLastLineOfAFlood) {
  const Ends ends = run({shell("yes 'much to say' | head -n 200000 >&2; printf 'the end' >&2")});
  EXPECT_EQ(ends.at(0).last_line, "the end");
}

TEST(ChildPool, SpellsOutWhatIsNotPrintable) {
  EXPECT_EQ(run({shell("printf 'a\\033[31mb\\n' >&2")}).at(0).last_line, "a\\x1b[31mb");
}

TEST(ChildPool, ChildrenMayBeStoppedEvenWhereWeMayNot) {
  sigset_t both, old;
  sigemptyset(&both);
  sigaddset(&both, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &both, &old);
  EXPECT_EQ(run({shell("kill -TERM $$; exit 5")}).at(0).status, 128 + SIGTERM);
  pthread_sigmask(SIG_SETMASK, &old, nullptr);
}

TEST(ChildPool, StopsWhatTakesTooLong) {
  const Ends ends = run({{"/bin/sleep", "600"}, shell("exit 0")},
                        {.at_once = 2, .timeout = std::chrono::seconds(1)});
  EXPECT_TRUE(ends.at(0).timed_out);
  EXPECT_FALSE(ends.at(1).timed_out);
}

TEST(ChildPool, StopsWhatWillNotBeStopped) {
  const Ends ends = run({shell("trap '' TERM; while :; do sleep 600; done")},
                        {.at_once = 1, .timeout = std::chrono::seconds(0)});
  EXPECT_TRUE(ends.at(0).timed_out);
  EXPECT_EQ(ends.at(0).status, 128 + SIGKILL);
}

// A pipe between the children: with two at once both get through it, one alone would wait for ever.
TEST(ChildPool, RunsAsManyAtOnceAsAsked) {
  const TemporaryFolder home;
  const std::string pipe = home.path() / "pipe";
  const Ends ends = run({shell("mkfifo " + pipe + "; echo x > " + pipe),
                         shell("until test -p " + pipe + "; do :; done; read word < " + pipe)},
                        {.at_once = 2, .timeout = std::chrono::seconds(60)});
  EXPECT_EQ(ends.at(0).status, 0);
  EXPECT_EQ(ends.at(1).status, 0);
}

TEST(ChildPool, OneAtATimeKeepsTheOrder) {
  const TemporaryFolder home;
  const std::string file = home.path() / "order";
  std::vector<std::vector<std::string>> commands;
  for (int i = 0; i < 5; ++i)
    commands.push_back(shell("printf " + std::to_string(i) + " >> " + file));
  run(commands);
  std::ifstream stream(file);
  std::string order;
  stream >> order;
  EXPECT_EQ(order, "01234");
}

TEST(ChildPool, LeavesNoProcessBehindWhenItIsStopped) {
  const TemporaryFolder home;
  const auto pipe = home.path() / "pipe", ready = home.path() / "ready";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  pollfd end{::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC), POLLIN, 0};
  ASSERT_GE(end.fd, 0);
  const auto still_wanted = [&] {
    if (std::filesystem::exists(ready)) throw Stopped();
  };
  const std::string script =
      "exec 3> " + pipe.string() + "; sleep 600 & : > " + ready.string() + "; wait";
  EXPECT_THROW(run_children(
                   {shell(script)}, {}, [](auto, const auto&) {}, still_wanted),
               Stopped);
  // The pipe hangs up when the last process that holds it is gone.
  EXPECT_EQ(::poll(&end, 1, 60000), 1);
  EXPECT_TRUE(end.revents & POLLHUP);
  ::close(end.fd);
}

}  // namespace
}  // namespace regarment
