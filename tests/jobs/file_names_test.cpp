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
  const std::string longest(255, 'a');
  for (const std::string& name :
       {std::string("a"), std::string("a b/c..d"), longest + "/" + longest,
        std::string("1/2/3/4/5/6/7/8"), std::string("\xc3\xa4")})
    EXPECT_TRUE(is_file_name(name)) << name;
  for (const std::string& name :
       {std::string(), std::string("/"), std::string("/a"), std::string("a/"), std::string("a//b"),
        std::string("."), std::string(".."), std::string("../a"), std::string("a/../b"),
        std::string(".a"), std::string("a/.b"), std::string("a\\b"), std::string("a\nb"),
        std::string("a\0b", 3), std::string("\x7f"), longest + "a",
        std::string("1/2/3/4/5/6/7/8/9")})
    EXPECT_FALSE(is_file_name(name)) << name;
}

}  // namespace
}  // namespace regarment
