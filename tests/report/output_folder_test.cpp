#include "report/output_folder.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "report/files.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

TEST(OutputFolder, AppearsOnlyWhenPublished) {
  const TemporaryFolder home;
  const fs::path place = home.path() / "out";
  OutputFolder out(place, false);
  out.write("a.txt", "A");
  out.write("sub/b.txt", "B");
  EXPECT_FALSE(fs::exists(place));
  out.publish();
  EXPECT_EQ(names_in(home.path()), Names{"out"});
  EXPECT_EQ(read_file(place / "a.txt", 10), "A");
  EXPECT_EQ(read_file(place / "sub/b.txt", 10), "B");
}

TEST(OutputFolder, LeavesNothingWhenNotPublished) {
  const TemporaryFolder home;
  { OutputFolder(home.path() / "x/y/out", false).write("a.txt", "A"); }
  EXPECT_EQ(names_in(home.path()), Names{});
}

TEST(OutputFolder, MakesParentsAndFollowsTheUmask) {
  const TemporaryFolder home;
  const fs::path place = home.path() / "x/y/out";
  OutputFolder out(place, false);
  out.publish();
  fs::create_directory(home.path() / "plain");
  EXPECT_EQ(fs::status(place).permissions(), fs::status(home.path() / "plain").permissions());
}

TEST(OutputFolder, TakesAnEmptyFolder) {
  const TemporaryFolder home;
  fs::create_directory(home.path() / "out");
  OutputFolder out(home.path() / "out/", false);
  out.write("a.txt", "A");
  out.publish();
  EXPECT_EQ(names_in(home.path() / "out"), Names{"a.txt"});
}

TEST(OutputFolder, TakesAFullFolderOnlyWhenTold) {
  const TemporaryFolder home;
  const fs::path place = home.path() / "out";
  fs::create_directory(place);
  write_file(place / "old.txt", "old");
  EXPECT_THROW(OutputFolder(place, false), UsageError);
  EXPECT_EQ(names_in(place), Names{"old.txt"});
  OutputFolder out(place, true);
  out.write("new.txt", "new");
  EXPECT_EQ(names_in(place), Names{"old.txt"});
  out.publish();
  EXPECT_EQ(names_in(place), Names{"new.txt"});
}

TEST(OutputFolder, RemovesTheReplacedFolder) {
  const TemporaryFolder home;
  fs::create_directory(home.path() / "out");
  write_file(home.path() / "out/old.txt", "old");
  { OutputFolder(home.path() / "out", true).publish(); }
  EXPECT_EQ(names_in(home.path()), Names{"out"});
}

TEST(OutputFolder, KeepsWhatFilledThePlaceMeanwhile) {
  const TemporaryFolder home;
  const fs::path place = home.path() / "out";
  {
    OutputFolder out(place, false);
    fs::create_directory(place);
    write_file(place / "other.txt", "x");
    EXPECT_THROW(out.publish(), UsageError);
  }
  EXPECT_EQ(names_in(home.path()), Names{"out"});
  EXPECT_EQ(names_in(place), Names{"other.txt"});
}

TEST(OutputFolder, FollowsALinkToAFolder) {
  const TemporaryFolder home;
  fs::create_directory(home.path() / "real");
  fs::create_directory_symlink(home.path() / "real", home.path() / "link");
  OutputFolder out(home.path() / "link", false);
  out.write("a.txt", "A");
  out.publish();
  EXPECT_TRUE(fs::is_symlink(home.path() / "link"));
  EXPECT_EQ(names_in(home.path() / "real"), Names{"a.txt"});
}

TEST(OutputFolder, RefusesFilesAndPlacesBelowFiles) {
  const TemporaryFolder home;
  write_file(home.path() / "file", "x");
  EXPECT_THROW(OutputFolder(home.path() / "file", true), UsageError);
  EXPECT_THROW(OutputFolder(home.path() / "file/out", true), UsageError);
  EXPECT_THROW(OutputFolder("", true), UsageError);
  EXPECT_THROW(OutputFolder("/proc/regarment/out", true), UsageError);
  EXPECT_EQ(names_in(home.path()), Names{"file"});
}

TEST(OutputFolder, NeverReplacesTheInputOrTheRoot) {
  const TemporaryFolder home;
  fs::create_directory(home.path() / "scans");
  const fs::path scan = home.path() / "scans/a.ply";
  write_file(scan, "x");
  EXPECT_THROW(OutputFolder(home.path() / "scans", true, {scan}), UsageError);
  EXPECT_THROW(OutputFolder(home.path(), true, {scan}), UsageError);
  EXPECT_THROW(OutputFolder("/", true), UsageError);
  EXPECT_THROW(OutputFolder(fs::current_path(), true), UsageError);
  EXPECT_TRUE(fs::exists(scan));
}

TEST(CheckOutputFolder, LeavesNothing) {
  const TemporaryFolder home;
  check_output_folder(home.path() / "x/out", false);
  EXPECT_EQ(names_in(home.path()), Names{});
}

TEST(WriteError, TellsAFullDiskFromAForbiddenPlace) {
  EXPECT_THROW(throw_write_error("f", ENOSPC), TemporaryError);
  EXPECT_THROW(throw_write_error("f", EDQUOT), TemporaryError);
  EXPECT_THROW(throw_write_error("f", EACCES), UsageError);
  EXPECT_THROW(throw_write_error("f", EROFS), UsageError);
}

}  // namespace
}  // namespace regarment
