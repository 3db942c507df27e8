#include "batch/run_scans.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <numeric>

#include "base/error.h"
#include "batches.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using State = ScanStatus::State;

/// A batch whose program is a shell script that sees the scan's path as $2.
class RunScans : public ::testing::Test {
 protected:
  // Each call of the program leaves the scan's name in `calls`.
  void program(const std::string& script) {
    std::ofstream(options_.program)
        << "#!/bin/sh\nname=$(basename \"$2\" .ply)\ncd '" << home_.path().string()
        << "'\necho $name >>calls\ntimes=$(grep -c \"^$name$\" calls)\n"
        << script << "\n";
    fs::permissions(options_.program, fs::perms::owner_all);
  }

  void run(int at_once = 1) {
    options_.at_once = at_once;
    std::vector<std::size_t> all(plan_.scans.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    run_scans(folder_, plan_, all, options_,
              {[&](std::size_t i, const ScanStatus& s) { told_[plan_.scans[i].name] = s; },
               [&] { look_(); }});
  }

  std::vector<std::string> calls() const {
    std::ifstream stream(home_.path() / "calls");
    std::vector<std::string> out;
    for (std::string line; std::getline(stream, line);) out.push_back(line);
    return out;
  }

  TemporaryFolder home_;
  Manifest plan_ = plan_of({"a", "b", "c"});
  BatchFolder folder_ = BatchFolder::create(home_.path() / "batch");
  RunScansOptions options_{home_.path() / "program", 1};
  std::map<std::string, ScanStatus> told_;
  std::function<void()> look_ = [] {};
};

TEST_F(RunScans, AReasonOfItsOwnIsFinal) {
  program("echo 'regarment: no person' >&2; exit 3");
  run();
  EXPECT_EQ(calls(), (std::vector<std::string>{"a", "b", "c"}));
  ASSERT_EQ(told_.size(), 3u);
  EXPECT_EQ(told_["b"].state, State::Failed);
  EXPECT_EQ(told_["b"].failure->line, "no person");
  EXPECT_TRUE(folder_.status(plan_.scans[1]));
}

TEST_F(RunScans, WhatCrashesComesBackAfterTheOthersAndIsParked) {
  program("[ $name != a ] || kill -SEGV $$; exit 4");
  run();
  EXPECT_EQ(calls(), (std::vector<std::string>{"a", "b", "c", "a", "a"}));
  EXPECT_EQ(told_["a"].state, State::Parked);
  EXPECT_EQ(told_["a"].failure->line, "tried 3 times: ended by signal 11");
  EXPECT_EQ(told_["c"].state, State::Failed);
  EXPECT_EQ(folder_.attempts("a"), 0);
}

TEST_F(RunScans, ATemporaryFailureMayPass) {
  program("[ $times = 3 ] || exit 75; exit 4");
  run(2);
  EXPECT_EQ(calls().size(), 9u);
  for (const char* name : {"a", "b", "c"}) EXPECT_EQ(told_[name].state, State::Failed) << name;
}

TEST_F(RunScans, AScanThatTookItsRunnersDownIsNotTouchedAgain) {
  program("exit 4");
  for (int i = 0; i < kMostAttempts; ++i) folder_.begin_attempt("b");
  folder_.begin_attempt("a");
  run();
  EXPECT_EQ(calls(), (std::vector<std::string>{"c", "a"})) << "those with fewer attempts first";
  EXPECT_EQ(told_["b"].state, State::Parked);
  EXPECT_NE(told_["b"].failure->line.find("3 times"), std::string::npos);
}

TEST_F(RunScans, BeingStoppedCostsNoAttempt) {
  program("exec sleep 1000");
  folder_.begin_attempt("b");
  bool begun = false;
  look_ = [&] {
    if (folder_.attempts("b") == 2) begun = true;
    if (begun) throw Stopped();
  };
  EXPECT_THROW(run(3), Stopped);
  EXPECT_EQ(folder_.attempts("a"), 0);
  EXPECT_EQ(folder_.attempts("b"), 1);
  EXPECT_TRUE(told_.empty());
}

TEST_F(RunScans, ALongFitIsEndedAndFailed) {
  plan_ = plan_of({"a"});
  plan_.timeout = 1;
  program("exec sleep 1000");
  run();
  EXPECT_EQ(told_["a"].failure->kind, "time-out");
  EXPECT_EQ(calls().size(), 1u);
}

TEST_F(RunScans, ASuccessNeedsAResult) {
  program("exit 0");
  fs::create_directories(folder_.fit("a"));
  std::ofstream(folder_.fit("a") / "result.json") << "of other options";
  run();
  EXPECT_EQ(told_["a"].state, State::Failed);
  EXPECT_FALSE(fs::exists(folder_.fit("a")));
  EXPECT_EQ(told_["b"].failure->kind, "internal error");
}

}  // namespace
}  // namespace regarment
