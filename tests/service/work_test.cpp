// A worker that reaches the store and the server alone, against a server in this process; the
// program is a shell script.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/sha256.h"
#include "jobs/file_names.h"
#include "jobs/server_files.h"
#include "jobs/sweep.h"
#include "jobs/worker.h"
#include "service/job_service.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Json = nlohmann::json;

constexpr std::size_t kMost = 1U << 20U;

bool always() { return true; }

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string hash_of(const std::string& text) { return sha256_hex(std::as_bytes(std::span(text))); }

class WorkTest : public testing::Test {
 protected:
  WorkTest() { key_ = issue_key(*store_, "worker", {Scope::Work}); }

  std::string queue(NewJob job = {}) {
    job.id = new_job_id();
    std::ofstream(folders_.begin_upload(job.id) / "scan.ply") << "ply of " << job.id;
    folders_.accept_upload(job.id);
    store_->create(job);
    return job.id;
  }
  Claim claim() { return *store_->claim("w", 1h, 3); }
  FileServer file_server() {
    FileServer out{{false, "127.0.0.1", server_.port()}, {}, 0ms};
    out.client.key = key_;
    return out;
  }
  ClientAnswer ask(const std::string& method, const std::string& target,
                   const std::string& body = {}) {
    HttpClient client(file_server().address, file_server().client);
    return client.ask({method, target, {}, body}, kMost, always);
  }
  int put(const Claim& claim, const std::string& name, const std::string& text,
          const std::string& hash = {}) {
    const std::string target = "/v1/work/" + claim.job.id + "/result/" + name +
                               "?token=" + std::to_string(claim.token) + "&sha256=";
    return ask("PUT", target + (hash.empty() ? hash_of(text) : hash), text).status;
  }
  ClientAnswer commit(const Claim& claim, const Json& files) {
    return ask("POST", "/v1/work/" + claim.job.id + "/result?token=" + std::to_string(claim.token),
               Json{{"files", files}}.dump());
  }
  fs::path delivery(const Claim& claim) { return folders_.delivery(claim.job.id, claim.token); }

  TemporaryFolder folder_;
  JobFolders folders_{folder_.path() / "data"};
  std::unique_ptr<JobStore> store_ = open_job_store(folders_.default_store().string());
  ServiceConfig config_ = [] {
    ServiceConfig out;
    out.min_free_mb = 0, out.fit_file_mb = 1;
    return out;
  }();
  Service service_{*store_, folders_, config_, {}};
  std::ostringstream log_;
  JobService handler_{service_, log_};
  Server server_{{}, handler_};
  std::string key_;
};

TEST_F(WorkTest, NeedsTheScopeOfWorkers) {
  queue();
  const std::string work = "/v1/work/" + claim().job.id;
  const std::string good = key_;
  for (const Scope scope : kScopes) {
    key_ = issue_key(*store_, "other", {scope});
    const bool may = scope == Scope::Work || scope == Scope::Admin;
    EXPECT_EQ(ask("GET", "/v1/work").status, may ? 200 : 403);
    EXPECT_EQ(ask("POST", work + "/start?token=1").status, may ? 200 : 403);
    EXPECT_EQ(ask("GET", work + "/files/x?token=1").status, may ? 404 : 403);
    EXPECT_EQ(ask("PUT", work + "/result/x?token=1").status, may ? 400 : 403);
    EXPECT_EQ(ask("POST", work + "/result?token=1").status, may ? 400 : 403);
  }
  key_ = good;
  EXPECT_EQ(ask("GET", work.substr(0, 4) + "jobs/" + work.substr(9)).status, 404);
}

TEST_F(WorkTest, NothingIsGivenOrTakenWithoutTheClaim) {
  const std::string id = queue();
  const Claim mine = claim();
  const std::string work = "/v1/work/" + id;
  const std::pair<const char*, const char*> asked[] = {{"POST", "/start?token="},
                                                       {"POST", "/result?token="},
                                                       {"GET", "/files/x?token="},
                                                       {"PUT", "/result/x?token="}};
  for (const char* token : {"0", "2", "-1", "9223372036854775807"}) {
    for (const auto& [method, path] : asked)
      EXPECT_EQ(ask(method, work + path + token).status, 409) << method << path << token;
  }
  for (const char* query : {"", "?token=", "?token=x", "?token=1x", "?token=99999999999999999999"})
    EXPECT_EQ(ask("POST", work + "/start" + query).status, 400) << query;
  EXPECT_EQ(ask("POST", "/v1/work/" + new_job_id() + "/start?token=1").status, 404);
  EXPECT_EQ(ask("POST", "/v1/work/x/start?token=1").status, 404);
  // Ended, it is nobody's.
  EXPECT_EQ(put(mine, "a", "a"), 204);
  store_->fail(id, mine.token, {"internal", "x"});
  EXPECT_EQ(put(mine, "b", "b"), 409);
  EXPECT_EQ(commit(mine, {{{"name", "a"}, {"bytes", 1}}}).status, 409);
  EXPECT_FALSE(fs::exists(folders_.result(id, mine.token)));
}

TEST_F(WorkTest, AResultAppearsWholeOnceItIsAllThere) {
  queue();
  const Claim mine = claim();
  EXPECT_EQ(put(mine, "report.html", "<p>"), 204);
  const Json list = {{{"name", "report.html"}, {"bytes", 3}},
                     {{"name", "pictures/a b.png"}, {"bytes", 5}}};
  EXPECT_EQ(commit(mine, list).status, 409);
  EXPECT_EQ(put(mine, "pictures/a%20b.png", "12345"), 204);
  EXPECT_EQ(commit(mine, Json::array({list[0]})).status, 409);  // one too many is there
  EXPECT_FALSE(fs::exists(folders_.result(mine.job.id, mine.token)));
  const ClientAnswer answer = commit(mine, list);
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(Json::parse(answer.body)["bytes"], folders_.bytes(mine.job.id));
  EXPECT_EQ(text_of(folders_.result(mine.job.id, mine.token) / "pictures/a b.png"), "12345");
  EXPECT_FALSE(fs::exists(delivery(mine)));
  // Its answer may have been lost.
  EXPECT_EQ(commit(mine, list).body, answer.body);
}

TEST_F(WorkTest, WhatIsNotAsAnnouncedIsNotTaken) {
  queue();
  const Claim mine = claim();
  EXPECT_EQ(put(mine, "a", "a", hash_of("b")), 422);
  EXPECT_EQ(put(mine, "a", "a", "abc"), 400);
  EXPECT_EQ(put(mine, "a", std::string((1U << 20U) + 1, 'x')), 413);
  EXPECT_TRUE(names_in(delivery(mine)).empty());
  for (const char* body : {"", "[]", "{}", R"({"files": []})", R"({"files": [{"name": "a"}]})",
                           R"({"files": [{"name": 1, "bytes": 1}]})"})
    EXPECT_EQ(ask("POST", "/v1/work/" + mine.job.id + "/result?token=1", body).status, 400) << body;
}

TEST_F(WorkTest, NoNameLeadsOutOfTheResult) {
  queue();
  const Claim mine = claim();
  for (const char* name : {"..", "../a", "%2e%2e/a", "a/../../b", "a%2fb", "a%5cb", ".hidden",
                           "a/.b", "a//b", "%00", "a%0ab", "1/2/3/4/5/6/7/8/9"})
    EXPECT_EQ(put(mine, name, "x"), 400) << name;
  EXPECT_EQ(names_in(folders_.data() / "jobs"), std::vector<std::string>{mine.job.id});
  EXPECT_EQ(names_in(folders_.job(mine.job.id)), std::vector<std::string>{"scan.ply"});
}

TEST_F(WorkTest, GivesOnlyWhatTheJobReads) {
  const std::string other = queue(), id = queue();
  const std::string first = claim().job.id;
  EXPECT_EQ(first, other);
  const Claim mine = claim();
  const std::string files = "/v1/work/" + id + "/files/";
  EXPECT_EQ(ask("GET", files + id + "/scan.ply?token=1").body, "ply of " + id);
  fs::create_symlink("/etc/passwd", folders_.job(id) / "labels.u8");
  fs::create_directory(folders_.result(id, 7));
  std::ofstream(folders_.result(id, 7) / "a") << "old";
  for (const std::string& name : {other + "/scan.ply", id + "/labels.u8", id + "/result-7/a", id,
                                  std::string("store.sqlite3"), id + "/none"})
    EXPECT_EQ(ask("GET", files + name + "?token=1").status, 404) << name;
}

TEST_F(WorkTest, AFullDiskIsToldBeforeAFileIsSent) {
  queue();
  const Claim mine = claim();
  config_.min_free_mb = 1U << 24U;
  EXPECT_EQ(put(mine, "a", "a"), 507);
}

TEST_F(WorkTest, AbandonedDeliveriesAreSwept) {
  const std::string id = queue();
  const Claim lost = claim();
  put(lost, "a", "a");
  store_->hand_back(id, lost.token);
  const Claim mine = claim();
  put(mine, "a", "a");
  EXPECT_EQ(sweep_data(*store_, folders_, 0ms, system_time()).abandoned, 1);
  EXPECT_FALSE(fs::exists(delivery(lost)));
  EXPECT_TRUE(fs::exists(delivery(mine)));
  store_->remove(id);
  EXPECT_EQ(sweep_data(*store_, folders_, 0ms, system_time()).abandoned, 1);
}

// The worker itself. $out is where its result goes.
class RemoteWorkerTest : public WorkTest {
 protected:
  Job run(const std::string& id, const std::string& script,
          const std::function<bool()>& wanted = always) {
    WorkerOptions options;
    options.program = folder_.path() / "program";
    std::ofstream(options.program)
        << "#!/bin/sh\nfor word; do case $word in --out=*) out=${word#--out=};; esac; done\n"
           "mkdir \"$out\"\n"
        << script;
    fs::permissions(options.program, fs::perms::owner_all);
    options.poll = 1ms, options.pause = 0ms, options.memory_mb = 0, options.until_empty = true;
    options.grace = grace_, options.lease = 100ms, options.max_attempts = attempts_;
    ServerFiles files(file_server(), folder_.path() / "scratch");
    run_worker(*store_, files, options, wanted);
    left_ = names_in(files.folders().data() / "jobs");
    return *store_->find(id);
  }

  std::chrono::milliseconds grace_{10'000};
  int attempts_ = 3;
  std::vector<std::string> left_;  // of jobs in the scratch folder
};

TEST_F(RemoteWorkerTest, FetchesTheScanAndDeliversTheResult) {
  const std::string id = queue();
  std::ofstream(folders_.job(id) / "truth.csv") << "scan\n";
  const Job job = run(id,
                      "mkdir \"$out/pictures\"; cp $2 \"$out/pictures/copy\"; echo \"$*\" > "
                      "\"$out/words\"; touch \"$out/.hidden\" \"$out/empty\"");
  ASSERT_EQ(job.state, JobState::Succeeded) << job.error->message;
  const fs::path result = folders_.result(job);
  EXPECT_EQ(file_names(result), (std::vector<std::string>{"empty", "pictures/copy", "words"}));
  EXPECT_EQ(text_of(result / "pictures/copy"), "ply of " + id);
  EXPECT_NE(
      text_of(result / "words").find("--ground-truth=" + folder_.path().string() + "/scratch"),
      std::string::npos);
  EXPECT_EQ(job.bytes, folders_.bytes(id));
  EXPECT_TRUE(left_.empty());
  EXPECT_TRUE(names_in(folder_.path() / "scratch").empty());
}

TEST_F(RemoteWorkerTest, FetchesTheResultThatARefitBeginsFrom) {
  const Job first = run(queue(),
                        "echo state > \"$out/state.bin\"; echo {} > \"$out/result.json\"; "
                        "echo x > \"$out/report.html\"");
  NewJob again;
  again.kind = JobKind::Refit, again.source = first.id;
  const Job second = run(queue(again), "ls $2 > \"$out/names\"; cp $2/state.bin \"$out\"");
  ASSERT_EQ(second.state, JobState::Succeeded) << second.error->message;
  EXPECT_EQ(text_of(folders_.result(second) / "names"), "result.json\nstate.bin\n");
  EXPECT_EQ(text_of(folders_.result(second) / "state.bin"), "state\n");
  store_->remove(first.id);
  EXPECT_EQ(run(queue(again), "").error->code, "bad_request");
}

TEST_F(RemoteWorkerTest, WhatIsWrongWithAJobIsSaidAsWithASharedFolder) {
  NewJob evaluation;
  evaluation.kind = JobKind::Evaluate;
  evaluation.batch = store_->create_batch("b", "").id;
  EXPECT_EQ(run(queue(evaluation), "").error->code, "bad_request");  // it has no result
  const std::string bare = queue();
  fs::remove(folders_.scan(bare));
  EXPECT_EQ(run(bare, "").error->code, "unreadable_scan");
}

TEST_F(RemoteWorkerTest, AResultThatIsTooLargeIsTriedAgainAndThenParked) {
  const Job job = run(queue(), "head -c 1048577 /dev/zero > \"$out/a\"");
  EXPECT_EQ(job.state, JobState::Dead);
  EXPECT_EQ(job.attempts, 3);
  EXPECT_EQ(job.error->code, "temporary");
}

TEST_F(RemoteWorkerTest, AKeyThatIsRevokedCostsNoJobAnAttempt) {
  const std::string id = queue();
  issue_key(*store_, "other", {Scope::Read});  // without any nobody would need one
  EXPECT_THROW(run(id, "",
                   [&] {
                     // Between the first look at the server and the first file.
                     if (store_->find(id)->state == JobState::Running)
                       store_->revoke_key(key_.substr(4, 12));
                     return true;
                   }),
               NoAccess);
  EXPECT_EQ(store_->find(id)->state, JobState::Queued);
  EXPECT_EQ(store_->find(id)->attempts, 0);
}

TEST_F(RemoteWorkerTest, NothingIsClaimedWhileTheServerIsAway) {
  const std::string id = queue();
  server_.stop();
  int asked = 0;
  const Job job = run(id, "", [&] { return ++asked < 4; });
  EXPECT_EQ(job.state, JobState::Queued);
  EXPECT_EQ(job.token, 0);
}

TEST_F(RemoteWorkerTest, AServerThatGoesAwayCostsAnAttempt) {
  const std::string id = queue();
  attempts_ = 1;
  const Job job = run(id, "echo x > \"$out/a\"", [&] {
    const JobState state = store_->find(id)->state;
    if (state == JobState::Running) server_.stop();
    return !has_ended(state);
  });
  EXPECT_EQ(job.state, JobState::Dead);
  EXPECT_EQ(job.error->code, "temporary");
}

}  // namespace
}  // namespace regarment
