// What every store holds to when many want the same at once.

#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <thread>

#include "store_places.h"

namespace regarment {
namespace {

using ContentionTest = JobStoreTest;

constexpr int kMany = 4;

// Calls `act` with a number and a store of its own, all at once.
void at_once(const std::string& where, const std::function<void(int, JobStore&)>& act) {
  std::vector<std::thread> threads;
  threads.reserve(kMany);
  for (int i = 0; i < kMany; ++i) {
    threads.emplace_back([&where, &act, i] { EXPECT_NO_THROW(act(i, *open_job_store(where))); });
  }
  for (std::thread& thread : threads) thread.join();
}

// Claims until nothing is left, and writes "ID\n" for each job it ended, in one write.
[[noreturn]] void be_a_worker(const std::string& where, int out) {
  {
    const auto store = open_job_store(where);
    while (const auto claim = store->claim("w", kLease, kAttempts)) {
      const std::string line = claim->job.id + "\n";
      if (store->succeed(claim->job.id, claim->token, 1)) (void)!::write(out, line.data(), 25);
    }
  }
  ::_exit(0);
}

TEST_F(ContentionTest, GivesEachJobToOneOfManyProcesses) {
  constexpr int kJobs = 60;
  std::map<std::string, int> ended;
  for (int i = 0; i < kJobs; ++i) ended[queue()] = 0;
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::vector<pid_t> workers;
  for (int i = 0; i < kMany; ++i) {
    workers.push_back(::fork());
    if (workers.back() == 0) be_a_worker(place_->where(), ends[1]);
  }
  ::close(ends[1]);
  std::string id(25, ' ');
  while (::read(ends[0], id.data(), id.size()) == 25) ++ended[id.substr(0, 24)];
  ::close(ends[0]);
  for (const pid_t worker : workers) ::waitpid(worker, nullptr, 0);
  EXPECT_EQ(ended.size(), static_cast<std::size_t>(kJobs));
  for (const auto& [job, times] : ended) EXPECT_EQ(times, 1) << job;
}

TEST_F(ContentionTest, MakesOneJobOfAKeyThatManyUse) {
  constexpr int kKeys = 20;
  std::array<std::array<Created, kKeys>, kMany> answers;
  at_once(place_->where(), [&](int who, JobStore& store) {
    for (int key = 0; key < kKeys; ++key) {
      NewJob job;
      job.id = new_job_id(), job.idempotency_key = "k" + std::to_string(key);
      answers[who][key] = store.create(job);
    }
  });
  for (int key = 0; key < kKeys; ++key) {
    int made = 0;
    for (const auto& one : answers) {
      made += one[key].kind == Created::Kind::Made ? 1 : 0;
      EXPECT_EQ(one[key].job.id, answers[0][key].job.id);
    }
    EXPECT_EQ(made, 1);
  }
  EXPECT_EQ(store_->facts().jobs[0], static_cast<std::uint64_t>(kKeys));
}

TEST_F(ContentionTest, EndsAClaimOnceWhoeverSaysSo) {
  constexpr int kJobs = 20;
  std::vector<Claim> claims;
  claims.reserve(kJobs);
  for (int i = 0; i < kJobs; ++i) queue();
  for (int i = 0; i < kJobs; ++i) claims.push_back(*store_->claim("w", kLease, kAttempts));
  std::array<int, kMany> ended{};
  at_once(place_->where(), [&](int who, JobStore& store) {
    for (const Claim& claim : claims) {
      const bool mine = who % 2 == 0 ? store.succeed(claim.job.id, claim.token, 1)
                                     : store.fail(claim.job.id, claim.token, {"x", "y"});
      ended[who] += mine ? 1 : 0;
    }
  });
  EXPECT_EQ(ended[0] + ended[1] + ended[2] + ended[3], kJobs);
  for (const Claim& claim : claims) {
    EXPECT_EQ(store_->events(claim.job.id, 0, 100).size(), 3U);  // queued, running, ended
  }
}

TEST_F(ContentionTest, RemovesABatchWithItsLastJobWhoeverRemovesThat) {
  for (int round = 0; round < 10; ++round) {
    NewJob job;
    job.batch = store_->create_batch("b", "").id;
    std::array<std::string, kMany> ids;
    std::generate(ids.begin(), ids.end(), [&] { return queue(job); });
    at_once(place_->where(), [&](int who, JobStore& store) { store.remove(ids[who]); });
    EXPECT_FALSE(store_->find_batch(job.batch));
  }
}

TEST_F(ContentionTest, OpensAnEmptyPlaceOnceForAll) {
  for (int round = 0; round < 5; ++round) {
    const auto fresh = new_store_place();
    std::array<int, kMany> versions{};
    at_once(fresh->where(),
            [&](int who, JobStore& store) { versions[who] = store.schema_version(); });
    for (const int version : versions) EXPECT_EQ(version, store_->schema_version());
  }
}

}  // namespace
}  // namespace regarment
