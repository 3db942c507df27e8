#include "jobs/file_names.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

TEST(FileNames, AreThoseOfVisibleFilesSorted) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "b/c");
  fs::create_directory(folder.path() / ".hidden");
  for (const char* name : {"z", "b/c/d", "b/a", ".part", ".hidden/a", "b/.part"})
    std::ofstream(folder.path() / name) << "x";
  fs::create_symlink("z", folder.path() / "link");
  fs::create_directory_symlink("b", folder.path() / "way");
  EXPECT_EQ(file_names(folder.path()), (std::vector<std::string>{"b/a", "b/c/d", "z"}));
  EXPECT_TRUE(file_names(folder.path() / "none").empty());
  for (const std::string& name : file_names(folder.path())) EXPECT_TRUE(is_file_name(name));
}

TEST(FileNames, LeadNowhereElse) {
  const std::string longest(255, 'a'), too_long(256, 'a'), deepest = "1/2/3/4/5/6/7/8";
  const std::string good[] = {"a", "a b/c..d", longest, "b/" + longest, deepest, "\xc3\xa4"};
  for (const std::string& name : good) EXPECT_TRUE(is_file_name(name)) << name;
  const std::string bad[] = {
      "",     "/",      "/a",          "a/",   "a//b", ".",    "..",
      "../a", "a/../b", ".a",          "a/.b", "a\\b", "a\nb", std::string(1, '\0'),
      "\x7f", too_long, deepest + "/9"};
  for (const std::string& name : bad) EXPECT_FALSE(is_file_name(name)) << name;
}

}  // namespace
}  // namespace regarment
