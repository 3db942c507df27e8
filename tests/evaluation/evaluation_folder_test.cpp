#include "evaluation/evaluation_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "report/files.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

TEST(EvaluationFolder, IsMadeWithItsParents) {
  const TemporaryFolder home;
  const EvaluationFolder folder(home.path() / "a/b");
  folder.write("evaluation.json", "{}");
  EXPECT_EQ(names_in(home.path() / "a/b"), (std::vector<std::string>{"evaluation.json", "fits"}));
}

TEST(EvaluationFolder, ReplacesAFileInOneStep) {
  const TemporaryFolder home;
  const EvaluationFolder folder(home.path() / "e");
  folder.write("evaluation.csv", "old and longer");
  folder.write("evaluation.csv", "new");
  EXPECT_EQ(read_file(home.path() / "e/evaluation.csv", 100), "new");
  EXPECT_EQ(names_in(home.path() / "e"), (std::vector<std::string>{"evaluation.csv", "fits"}));
}

TEST(EvaluationFolder, KeepsFitsAndRemovesHalfWrittenOnes) {
  const TemporaryFolder home;
  fs::create_directories(home.path() / "fits/whole");
  fs::create_directories(home.path() / "fits/.regarment-Ab12Cd/pictures");
  const EvaluationFolder folder(home.path());
  EXPECT_EQ(names_in(home.path() / "fits"), std::vector<std::string>{"whole"});
}

TEST(EvaluationFolder, LeavesAForeignFolderAlone) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "letter.txt") << "dear";
  EXPECT_THROW(EvaluationFolder{home.path()}, UsageError);
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{"letter.txt"});
  EXPECT_THROW(EvaluationFolder{home.path() / "letter.txt"}, UsageError);
}

TEST(EvaluationFolder, HasRoomForOneProgramAtATime) {
  const TemporaryFolder home;
  {
    const EvaluationFolder folder(home.path());
    EXPECT_THROW(EvaluationFolder{home.path()}, UsageError);
  }
  EXPECT_NO_THROW(EvaluationFolder{home.path()});
}

}  // namespace
}  // namespace regarment
