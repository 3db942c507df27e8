#include "jobs/scratch_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "base/error.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolder, IsItsOwnersAndGoesWithIt) {
  const TemporaryFolder folder;
  const fs::path parent = folder.path() / "a/b";
  {
    const ScratchFolder one(parent), other(parent);
    EXPECT_NE(one.path(), other.path());
    EXPECT_EQ(one.path().parent_path(), parent);
    EXPECT_EQ(fs::status(one.path()).permissions(), fs::perms::owner_all);
    std::ofstream(one.path() / "file") << "x";
  }
  EXPECT_TRUE(names_in(parent).empty());
}

TEST(ScratchFolder, RemovesWhatTheDeadLeftAndNothingElse) {
  const TemporaryFolder folder;
  const ScratchFolder living(folder.path());
  std::ofstream(living.path() / "file") << "x";
  fs::create_directories(folder.path() / "worker-dead/jobs");
  fs::create_directory(folder.path() / "jobs");
  fs::create_directory_symlink("jobs", folder.path() / "worker-link");
  const ScratchFolder next(folder.path());
  EXPECT_TRUE(fs::exists(living.path() / "file"));
  EXPECT_FALSE(fs::exists(folder.path() / "worker-dead"));
  EXPECT_TRUE(fs::exists(folder.path() / "jobs"));
}

TEST(ScratchFolder, NeedsAPlace) { EXPECT_THROW(ScratchFolder("/proc/none"), UsageError); }

}  // namespace
}  // namespace regarment
