#include "batch/batch_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "base/error.h"
#include "batches.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

ScanStatus failed_status(const BatchScan& scan) {
  return {ScanStatus::State::Failed, scan.name, scan.key, "", ScanFailure{"kind", 3, "a \"line\""}};
}

TEST(BatchFolder, TakesAnEmptyPlaceOrABatchAndNothingElse) {
  const TemporaryFolder home;
  EXPECT_THROW(BatchFolder(home.path()), ReadError);
  std::ofstream(home.path() / "thesis.tex") << "x";
  EXPECT_THROW(BatchFolder::create(home.path()), UsageError);
  const BatchFolder folder = BatchFolder::create(home.path() / "new/batch");
  folder.write_manifest(manifest_json(plan_of({"a"})));
  EXPECT_EQ(BatchFolder(home.path() / "new/batch").manifest().scans.size(), 1u);
  BatchFolder::create(home.path() / "new/batch");
}

TEST(BatchFolder, KnowsAStatusOfTheSameKeyOnly) {
  const TemporaryFolder home;
  const BatchFolder folder = BatchFolder::create(home.path() / "b");
  BatchScan scan = plan_of({"a"}).scans[0];
  EXPECT_FALSE(folder.status(scan));
  folder.write_status(failed_status(scan));
  ASSERT_TRUE(folder.status(scan));
  EXPECT_EQ(folder.status(scan)->failure->line, "a \"line\"");
  scan.key = "another";
  EXPECT_FALSE(folder.status(scan));
}

TEST(BatchFolder, TakesNoStatusThatWasCutOff) {
  const TemporaryFolder home;
  const BatchFolder folder = BatchFolder::create(home.path() / "b");
  const BatchScan scan = plan_of({"a"}).scans[0];
  const std::string whole = status_json(failed_status(scan));
  for (std::size_t size = 0; size < whole.size() - 1; ++size) {
    std::ofstream(home.path() / "b/status/a.json") << whole.substr(0, size);
    EXPECT_FALSE(folder.status(scan)) << size;
  }
  std::ofstream(home.path() / "b/status/a.json") << whole;
  EXPECT_TRUE(folder.status(scan));
}

TEST(BatchFolder, ASuccessNeedsTheResultThatWasFinished) {
  const TemporaryFolder home;
  const BatchFolder folder = BatchFolder::create(home.path() / "b");
  const BatchScan scan = plan_of({"a"}).scans[0];
  fs::create_directories(folder.fit("a"));
  std::ofstream(folder.fit("a") / "result.json") << "{}";
  folder.write_status({ScanStatus::State::Succeeded, "a", scan.key, folder.result_sha256("a"), {}});
  EXPECT_TRUE(folder.status(scan));
  std::ofstream(folder.fit("a") / "result.json") << "{ }";
  EXPECT_FALSE(folder.status(scan));
  fs::remove_all(folder.fit("a"));
  EXPECT_FALSE(folder.status(scan));
}

TEST(BatchFolder, CountsAttemptsUntilOneEnds) {
  const TemporaryFolder home;
  const BatchFolder folder = BatchFolder::create(home.path() / "b");
  EXPECT_EQ(folder.attempts("a"), 0);
  for (int i = 0; i < 3; ++i) folder.begin_attempt("a");
  EXPECT_EQ(folder.attempts("a"), 3);
  folder.give_back_attempt("a");
  EXPECT_EQ(folder.attempts("a"), 2);
  folder.write_status(failed_status(plan_of({"a"}).scans[0]));
  EXPECT_EQ(folder.attempts("a"), 0);
  folder.give_back_attempt("a");
  EXPECT_EQ(names_in(home.path() / "b/attempts"), std::vector<std::string>{});
}

TEST(BatchLock, SharesABatchByShards) {
  const TemporaryFolder home;
  const BatchFolder folder = BatchFolder::create(home.path() / "b");
  {
    const BatchLock one = BatchLock::shard(folder, 1);
    EXPECT_NO_THROW(BatchLock::shard(folder, 0));
    EXPECT_NO_THROW(BatchLock::shard(folder, 2));
    EXPECT_THROW(BatchLock::shard(folder, 1), TemporaryError);
    EXPECT_THROW(BatchLock::whole(folder), TemporaryError);
  }
  const BatchLock all = BatchLock::whole(folder);
  EXPECT_THROW(BatchLock::shard(folder, 999), TemporaryError);
}

}  // namespace
}  // namespace regarment
