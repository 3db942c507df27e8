#include "support/bad_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <set>

#include "base/error.h"
#include "scan/read_sandboxed.h"
#include "support/folders.h"

namespace regarment::test {
namespace {

TEST(BadFiles, AreSixtyAtLeastAndHaveTitlesOfTheirOwn) {
  std::set<std::string> titles;
  for (const BadFile& file : bad_files()) titles.insert(file.title);
  EXPECT_EQ(titles.size(), bad_files().size());
  EXPECT_GE(titles.size(), 60U);
}

TEST(BadFiles, EachGivesOneLineThatSaysWhat) {
  for (const BadFile& file : bad_files()) {
    SCOPED_TRACE(file.title);
    const TemporaryFolder folder;
    try {
      read_mesh_sandboxed(put(file, folder.path()));
      ADD_FAILURE() << "it was read";
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.exit_status(), file.exit_status);
      EXPECT_NE(message.find(file.says), std::string::npos) << message;
      for (const char c : message) {
        EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 || c == 0x7f) << message;
      }
      EXPECT_LT(message.size(), 700U) << message;
    }
  }
  struct rusage children {};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &children), 0);
  EXPECT_LT(children.ru_maxrss, 1L << 20U) << "KiB, the promise of 1 GiB";
}

}  // namespace
}  // namespace regarment::test
