#include "jobs/sweep.h"

#include <gtest/gtest.h>

#include <fstream>

#include "store_places.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class SweepTest : public testing::Test {
 protected:
  std::string folder_of_job() {
    std::string id = new_job_id();
    std::ofstream(folders_.begin_upload(id) / "scan.ply") << "ply";
    folders_.accept_upload(id);
    return id;
  }
  std::string cancelled() {
    NewJob job;
    job.id = folder_of_job();
    store_->create(job);
    store_->cancel(job.id);
    return job.id;
  }

  TemporaryFolder folder_;
  HandClock time_;
  JobFolders folders_{folder_.path() / "data"};
  std::unique_ptr<JobStore> store_ =
      open_job_store(folders_.default_store().string(), time_.clock());
};

TEST_F(SweepTest, DeletesJobsAndFilesThatEndedLongAgo) {
  const std::string old = cancelled();
  time_.pass(2h);
  const std::string young = cancelled();
  EXPECT_EQ(sweep_data(*store_, folders_, 0ms, time_.now()).expired, 0);
  EXPECT_EQ(sweep_data(*store_, folders_, 1h, time_.now()).expired, 1);
  EXPECT_FALSE(store_->find(old) || fs::exists(folders_.job(old)));
  EXPECT_TRUE(store_->find(young) && fs::exists(folders_.job(young)));
}

TEST_F(SweepTest, RemovesWhatBelongsToNoJobOnceItIsOld) {
  const std::string known = cancelled(), unknown = folder_of_job();
  folders_.begin_upload(new_job_id());
  fs::create_directory(folders_.data() / "incoming" / "removed-x");
  fs::create_directory(folders_.data() / "jobs" / "lost+found");  // not ours
  EXPECT_EQ(sweep_data(*store_, folders_, 0ms, system_time()).abandoned, 1);
  EXPECT_EQ(sweep_data(*store_, folders_, 0ms, system_time() + 25h).abandoned, 2);
  EXPECT_TRUE(names_in(folders_.data() / "incoming").empty());
  std::vector<std::string> left = {known, "lost+found"};
  std::sort(left.begin(), left.end());
  EXPECT_EQ(names_in(folders_.data() / "jobs"), left);
}

TEST_F(SweepTest, FoldersAreForTheirOwnerAlone) {
  const std::string id = folder_of_job();
  for (const fs::path& one : {folders_.data(), folders_.job(id), folders_.data() / "jobs"}) {
    EXPECT_EQ(fs::status(one).permissions(), fs::perms::owner_all) << one;
  }
  EXPECT_EQ(fs::status(folders_.default_store()).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(SweepTest, NoIdLeadsOutOfTheFolder) {
  for (const char* id :
       {"", "..", "../../etc", "0123456789abcdef0123456", "0123456789abcdef0123456G"})
    EXPECT_ANY_THROW(folders_.job(id)) << id;
}

}  // namespace
}  // namespace regarment
