#include "batch/slurm_scripts.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "base/child_process.h"
#include "batches.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// Whatever a shell or sbatch might make something of.
constexpr const char* kHostile = "it's \"$HOME\" `id` $(id) ;&|<>*?~ #\n#SBATCH --wrap=id\n%A \\";

void write_program(const fs::path& file, const std::string& text) {
  std::ofstream(file) << "#!/bin/sh\n" << text;
  fs::permissions(file, fs::perms::owner_all);
}

ChildEnd run(const std::vector<std::string>& command) {
  ChildProcess child(command);
  ChildEnd end;
  do {
    wait_for_children({&child}, std::chrono::milliseconds(100));
    child.look_after();
  } while (!child.ended(end));
  return end;
}

SlurmOptions options_in(const fs::path& home) {
  SlurmOptions out;
  out.program = home / "program";
  out.folder = home / kHostile;
  out.here = home;
  fs::create_directories(out.folder / "log");
  return out;
}

TEST(SlurmScripts, WriteShardsAsSlurmDoes) {
  EXPECT_EQ(array_indices({}), "");
  EXPECT_EQ(array_indices({4}), "4");
  EXPECT_EQ(array_indices({0, 1, 2, 5, 7, 8}), "0-2,5,7-8");
}

TEST(SlurmScripts, LimitTheTasksAtOnce) {
  const TemporaryFolder home;
  SlurmOptions options = options_in(home.path());
  options.at_once = 3;
  EXPECT_NE(array_script(plan_of({"a", "b", "c"}), {0, 1}, options).find("--array=0-1%3\n"),
            std::string::npos);
}

// sbatch reads options from all lines before the first command.
TEST(SlurmScripts, LetNoPathSpeakToSlurm) {
  const TemporaryFolder home;
  const std::string script = array_script(plan_of({"a"}), {0}, options_in(home.path()));
  const auto first_command = script.find("\nset -u\n");
  ASSERT_NE(first_command, std::string::npos);
  EXPECT_GT(script.find("--wrap=id"), first_command);
  EXPECT_LT(script.find("--requeue"), first_command);
}

TEST(SlurmScripts, ATaskRunsItsShardInWhateverFolder) {
  const TemporaryFolder home;
  const SlurmOptions options = options_in(home.path());
  write_program(options.program, "printf '%s|' \"$@\" >\"$(dirname \"$0\")/words\"; pwd\n");
  std::ofstream(home.path() / "task") << array_script(plan_of({"a"}), {0}, options);
  ::setenv("SLURM_ARRAY_TASK_ID", "7", 1);
  EXPECT_EQ(run({"/bin/bash", home.path() / "task"}).status, 0);
  EXPECT_EQ(bytes_of(home.path() / "words"),
            "batch-task|" + options.folder.string() + "|--shard|7|--quiet|");
  EXPECT_EQ(bytes_of(options.folder / "log/shard-7.log"), home.path().string() + "\n");
}

TEST(SlurmScripts, WhatEndsATaskComesBackButNotForEver) {
  const TemporaryFolder home;
  const SlurmOptions options = options_in(home.path());
  std::ofstream(home.path() / "task") << merge_script(plan_of({"a"}), options);
  const auto status_after = [&](const std::string& program, const char* restarts) {
    write_program(options.program, program);
    ::setenv("SLURM_RESTART_COUNT", restarts, 1);
    return run({"/bin/bash", home.path() / "task"}).status;
  };
  EXPECT_EQ(status_after("exit 0", "0"), 0);
  EXPECT_EQ(status_after("exit 4", "0"), 4);
  EXPECT_EQ(status_after("exit 75", "0"), 75);
  EXPECT_EQ(status_after("kill -KILL $$", "0"), 75);
  EXPECT_EQ(status_after("kill -SEGV $$", "1"), 75);
  EXPECT_EQ(status_after("kill -SEGV $$", "1000"), 1);
  fs::remove_all(options.folder / "log");
  EXPECT_EQ(status_after("exit 0", "0"), 75) << "its log cannot be written";
}

// An sbatch that notes its words and answers as Slurm does in a federation.
TEST(SlurmScripts, SubmitTheArrayAndThenTheMerge) {
  const TemporaryFolder home;
  SlurmOptions options = options_in(home.path());
  options.words = {"--comment=" + std::string(kHostile)};
  write_program(
      home.path() / "sbatch",
      "printf '%s|' \"$@\" >>'" + (home.path() / "words").string() + "'\necho '41;cluster'\n");
  write_program(home.path() / "scontrol", "echo 'RequeueExit             = 75'\n");
  std::ofstream(home.path() / "submit") << submit_script(true, options);
  const std::string path = home.path().string() + ":" + ::getenv("PATH");
  const ChildEnd end = run({"/usr/bin/env", "PATH=" + path, "/bin/sh", "-c",
                            "exec /bin/sh \"$0\" 1>&2", home.path() / "submit"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.last_line, "array 41, merge 41");
  const std::string words = "--parsable|" + options.words[0] + "|", folder = options.folder;
  EXPECT_EQ(bytes_of(home.path() / "words"), words + folder + "/array.sbatch|" + words +
                                                 "--dependency=afterany:41|" + folder +
                                                 "/merge.sbatch|");
}

}  // namespace
}  // namespace regarment
