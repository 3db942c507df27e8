#include <gtest/gtest.h>
#include <signal.h>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

// A stage is told when it is over and the longer ones are still to come.
void expect_clean_stop(int signal, int status, const Arguments& more = {},
                       const std::string& after = "read") {
  const TemporaryFolder home;
  Arguments all = {
      "fit",   example("layered-1.mesh.ply"), "--garment", "tshirt", "--garment", "skirt",
      "--out", home.path() / "deep/out"};
  all.insert(all.end(), more.begin(), more.end());
  RunningProgram program(all, kFitSeconds);
  ASSERT_TRUE(program.wait_for_line(after));
  program.send(signal);
  const ProgramRun run = program.finish();
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(lines_of(run.err).back().starts_with("regarment: stopped by")) << run.err;
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{});
}

TEST(Signals, AnInterruptLeavesNothing) { expect_clean_stop(SIGINT, 130); }

TEST(Signals, ATerminationLeavesNothing) { expect_clean_stop(SIGTERM, 143); }

// The placement is told as over once the search has begun; so many drapes would take hours.
TEST(Signals, ATerminationEndsASearchInItsThreads) {
  expect_clean_stop(SIGTERM, 143,
                    {"--method", "annealing", "--evaluations", "100000", "--threads", "2"},
                    "place");
}

}  // namespace
}  // namespace regarment
