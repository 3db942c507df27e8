// The worker against a program whose behaviour the test writes: a shell script that gets the words
// the real one would get.

#include "jobs/worker.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <thread>

#include "base/error.h"
#include "store_places.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// $out is where the result goes.
constexpr const char* kPrelude = R"sh(#!/bin/sh
for word; do case $word in --out=*) out=${word#--out=};; esac; done
succeed() { mkdir "$out.half" && echo "$*" > "$out.half/words" && mv "$out.half" "$out"; }
)sh";

class WorkerTest : public testing::Test {
 protected:
  void program(const std::string& script) {
    options_.program = folder_.path() / "program";
    std::ofstream(options_.program) << kPrelude << script;
    fs::permissions(options_.program, fs::perms::owner_all);
    options_.poll = 1ms;
    options_.pause = 0ms;
    options_.memory_mb = 0;  // a sanitizer's address space is beyond any limit
    options_.until_empty = true;
    options_.host = "here";
  }
  std::string queue(NewJob job = {}) {
    job.id = new_job_id();
    std::ofstream(folders_.begin_upload(job.id) / "scan.ply") << "ply";
    folders_.accept_upload(job.id);
    store_->create(job);
    return job.id;
  }
  Job run(const std::string& id) {
    run_worker(*store_, files_, options_, [] { return true; });
    return *store_->find(id);
  }
  std::vector<std::string> files(const std::string& id) { return names_in(folders_.job(id)); }

  TemporaryFolder folder_;
  JobFolders folders_{folder_.path() / "data"};
  SharedFiles files_{folders_};
  std::unique_ptr<JobStore> store_ = open_job_store(folders_.default_store().string());
  WorkerOptions options_;
};

TEST_F(WorkerTest, RunsTheCommandOfTheJobAndKeepsItsResult) {
  program("succeed \"$@\"");
  NewJob job;
  job.garments = {"skirt", "tshirt"}, job.name = "/etc/a b.ply";
  job.options = R"({"method": "direct", "fix": {"length": 54.5}, "no_timing": true})";
  const std::string id = queue(job);
  options_.threads = 2;
  const Job done = run(id);
  ASSERT_EQ(done.state, JobState::Succeeded);
  const fs::path result = folders_.result(done);
  std::ifstream words(result / "words");
  std::string line;
  std::getline(words, line);
  EXPECT_EQ(line, "fit " + folders_.scan(id).string() +
                      " --garment=skirt --garment=tshirt --name=a b.ply --out=" + result.string() +
                      " --progress=json --threads=2 --method=direct --fix=length=54.5 --no-timing");
  EXPECT_EQ(done.bytes, line.size() + 1 + 3);  // the words and the scan
  EXPECT_TRUE(store_->workers({}).empty());    // it said goodbye
}

TEST_F(WorkerTest, TurnsProgressLinesIntoProgressAndEvents) {
  program(R"sh(
echo '{"stage":"read","fraction":1}' >&2; echo '{"stage":"fit","fraction":0.5,"detail":"x"}' >&2
echo 'no progress' >&2; succeed)sh");
  const Job done = run(queue());
  EXPECT_EQ(done.progress, 1);
  const auto events = store_->events(done.id, 0, 10);
  ASSERT_EQ(events.size(), 5U);
  EXPECT_EQ(events[2].kind, "progress");
  EXPECT_NE(events[3].data.find(R"("stage":"fit","detail":"x")"), std::string::npos);
}

TEST_F(WorkerTest, FailsAtOnceWhereAnotherTryWouldNotHelp) {
  const std::pair<int, std::string> cases[] = {
      {1, "internal"}, {2, "bad_request"}, {3, "unreadable_scan"}, {4, "no_garment"}};
  for (const auto& [status, code] : cases) {
    program(
        "echo '{\"stage\":\"read\",\"fraction\":0}' >&2; echo 'regarment: the line' >&2; exit " +
        std::to_string(status));
    const Job job = run(queue());
    EXPECT_EQ(job.state, JobState::Failed);
    EXPECT_EQ(job.attempts, 1);
    ASSERT_TRUE(job.error);
    EXPECT_EQ(job.error->code, code);
    EXPECT_EQ(job.error->message, "the line");
    EXPECT_EQ(files(job.id), std::vector<std::string>{"scan.ply"});
  }
}

TEST_F(WorkerTest, GivesACrashThreeTriesAndThenUp) {
  const std::pair<std::string, std::string> cases[] = {
      {"kill -SEGV $$", "crashed"},
      {"kill -KILL $$", "out_of_memory"},
      {"echo 'regarment: out of memory; give more' >&2; exit 75", "out_of_memory"},
      {"echo 'regarment: disk full' >&2; exit 75", "temporary"}};
  for (const auto& [script, code] : cases) {
    program("mkdir \"$out\"\n" + script);  // what a try leaves behind is no result
    const Job job = run(queue());
    EXPECT_EQ(job.state, JobState::Dead) << script;
    EXPECT_EQ(job.attempts, 3);
    EXPECT_EQ(job.error->code, code);
    EXPECT_EQ(files(job.id), std::vector<std::string>{"scan.ply"});
  }
}

TEST_F(WorkerTest, SucceedsAtTheSecondTry) {
  program(R"sh(case $out in *-1) kill -ABRT $$;; esac; succeed)sh");
  const Job job = run(queue());
  EXPECT_EQ(job.state, JobState::Succeeded);
  EXPECT_EQ(job.attempts, 2);
  EXPECT_EQ(files(job.id), (std::vector<std::string>{"result-2", "scan.ply"}));
}

TEST_F(WorkerTest, EndsWhatTakesTooLong) {
  program("sleep 100");
  options_.time = 50ms;
  options_.max_attempts = 1;
  EXPECT_EQ(run(queue()).error->code, "timed_out");
}

TEST_F(WorkerTest, LimitsTheFilesOfAChild) {
  program("head -c 3000000 /dev/zero > \"$out\" || exit 75");
  options_.file_mb = 1;
  options_.max_attempts = 1;
  EXPECT_EQ(run(queue()).state, JobState::Dead);
}

// The child says when it runs by a file; the test cancels then.
TEST_F(WorkerTest, KillsTheGroupOfACancelledJob) {
  program("sleep 1000 & echo $! > \"$out.pid\"; wait");
  options_.lease = 40ms;  // a heartbeat every 10 ms
  const std::string id = queue();
  const fs::path pid_file = folders_.job(id) / "result-1.pid";
  run_worker(*store_, files_, options_, [&] {
    if (fs::exists(pid_file) && fs::file_size(pid_file) > 0) store_->cancel(id);
    return true;
  });
  EXPECT_EQ(store_->find(id)->state, JobState::Cancelled);
  pid_t pid = 0;
  std::ifstream(pid_file) >> pid;
  // A zombie until init takes it: killed, though not yet gone.
  std::string state;
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  for (int i = 0; i < 3; ++i) stat >> state;
  EXPECT_TRUE(!stat || state == "Z") << state;
}

TEST_F(WorkerTest, LeavesAJobThatWasDeleted) {
  program("touch \"$out.began\"; sleep 1000");
  options_.lease = 40ms;
  const std::string id = queue();
  const fs::path began = folders_.job(id) / "result-1.began";
  run_worker(*store_, files_, options_, [&] {
    if (fs::exists(began)) store_->remove(id), folders_.remove(id);
    return true;
  });
  EXPECT_FALSE(store_->find(id));
  EXPECT_TRUE(names_in(folders_.data() / "jobs").empty());
}

TEST_F(WorkerTest, HandsItsJobBackWhenItMustGo) {
  program("touch \"$out.began\"; sleep 1000");
  options_.grace = 1ms;
  const std::string id = queue();
  const fs::path began = folders_.job(id) / "result-1.began";
  run_worker(*store_, files_, options_, [&] { return !fs::exists(began); });
  const auto job = store_->find(id);
  EXPECT_EQ(job->state, JobState::Queued);
  EXPECT_EQ(job->attempts, 0);
}

TEST_F(WorkerTest, FinishesAJobWithinItsGrace) {
  program("touch \"$out.began\"; succeed");
  options_.grace = 60s;
  const std::string id = queue();
  const fs::path began = folders_.job(id) / "result-1.began";
  run_worker(*store_, files_, options_, [&] { return !fs::exists(began); });
  EXPECT_EQ(store_->find(id)->state, JobState::Succeeded);
}

TEST_F(WorkerTest, RefitsTheResultOfAnotherJob) {
  program("succeed \"$@\"");
  const Job first = run(queue());
  NewJob again;
  again.kind = JobKind::Refit, again.source = first.id;
  const Job second = run(queue(again));
  ASSERT_EQ(second.state, JobState::Succeeded);
  std::ifstream words(folders_.result(second) / "words");
  std::string command, from;
  words >> command >> from;
  EXPECT_EQ(command, "refit");
  EXPECT_EQ(from, folders_.result(first).string());
  store_->remove(first.id);
  EXPECT_EQ(run(queue(again)).error->code, "bad_request");
}

TEST_F(WorkerTest, KeepsAnEvaluationWhoseScansPartlyFailed) {
  program("succeed \"$@\"; exit 4");
  NewJob job;
  job.kind = JobKind::Evaluate;
  const std::string id = queue(job);
  EXPECT_EQ(run(id).error->code, "unreadable_scan");  // it has no table
  store_->requeue(id);
  std::ofstream(folders_.job(id) / "truth.csv") << "scan\n";
  const Job done = run(id);
  ASSERT_EQ(done.state, JobState::Succeeded);
  std::ifstream words(folders_.result(done) / "words");
  std::string command, table;
  words >> command >> table;
  EXPECT_EQ(command, "evaluate");
  EXPECT_EQ(table, (folders_.job(id) / "truth.csv").string());
}

TEST_F(WorkerTest, RefusesAJobWithoutAScanOrWithWrongOptions) {
  program("succeed");
  const std::string bare = queue();
  fs::remove(folders_.scan(bare));
  EXPECT_EQ(run(bare).error->code, "unreadable_scan");
  NewJob wrong;
  wrong.options = R"({"out": "/etc"})";
  EXPECT_EQ(run(queue(wrong)).error->code, "bad_request");
}

TEST_F(WorkerTest, NeedsAProgram) {
  program("");
  options_.program = "/nowhere/regarment";
  EXPECT_THROW(run(queue()), UsageError);
}

}  // namespace
}  // namespace regarment
