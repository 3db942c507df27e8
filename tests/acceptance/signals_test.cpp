#include <gtest/gtest.h>
#include <signal.h>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

// The first stage is told when it is over and the longer ones are still to come.
void expect_clean_stop(int signal, int status) {
  const TemporaryFolder home;
  RunningProgram program({"fit", example("layered-1.mesh.ply"), "--garment", "tshirt", "--garment",
                          "skirt", "--out", home.path() / "deep/out"},
                         kFitSeconds);
  ASSERT_TRUE(program.wait_for_line("read"));
  program.send(signal);
  const ProgramRun run = program.finish();
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(lines_of(run.err).back().starts_with("regarment: stopped by")) << run.err;
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{});
}

TEST(Signals, AnInterruptLeavesNothing) { expect_clean_stop(SIGINT, 130); }

TEST(Signals, ATerminationLeavesNothing) { expect_clean_stop(SIGTERM, 143); }

}  // namespace
}  // namespace regarment
