// What every store does for workers: claims, leases, tokens, attempts.

#include "store_places.h"

namespace regarment {
namespace {

using namespace std::chrono_literals;
using ClaimTest = JobStoreTest;

TEST_F(ClaimTest, GivesTheJobThatWaitsLongestToOne) {
  const std::string first = queue(), second = queue();
  const auto a = store_->claim("w1", kLease, kAttempts);
  const auto b = store_->claim("w2", kLease, kAttempts);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->job.id, first);
  EXPECT_EQ(b->job.id, second);
  EXPECT_EQ(a->job.state, JobState::Running);
  EXPECT_EQ(a->job.worker, "w1");
  EXPECT_EQ(a->job.started, time_.now());
  EXPECT_EQ(a->job.attempts, 1);
  EXPECT_FALSE(store_->claim("w3", kLease, kAttempts));
}

TEST_F(ClaimTest, LendsAJobUntilItsLeaseIsOver) {
  const std::string id = queue();
  const auto first = store_->claim("w1", kLease, kAttempts);
  time_.pass(kLease - 1ms);
  EXPECT_FALSE(store_->claim("w2", kLease, kAttempts));
  EXPECT_EQ(store_->heartbeat(id, first->token, kLease), LeaseAnswer::Go);
  time_.pass(kLease - 1ms);
  EXPECT_FALSE(store_->claim("w2", kLease, kAttempts));
  time_.pass(1ms);
  const auto second = store_->claim("w2", kLease, kAttempts);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->job.id, id);
  EXPECT_EQ(second->job.attempts, 2);
  EXPECT_GT(second->token, first->token);
}

TEST_F(ClaimTest, RefusesEverythingUnderAnOldToken) {
  const std::string id = queue();
  const std::int64_t old = store_->claim("w1", kLease, kAttempts)->token;
  time_.pass(kLease);
  const std::int64_t now = store_->claim("w2", kLease, kAttempts)->token;
  EXPECT_EQ(store_->heartbeat(id, old, kLease), LeaseAnswer::Lost);
  EXPECT_EQ(store_->progress(id, old, 0.5, "fit", ""), LeaseAnswer::Lost);
  EXPECT_FALSE(store_->succeed(id, old, 1));
  EXPECT_FALSE(store_->fail(id, old, {"x", "y"}));
  EXPECT_FALSE(store_->cancelled(id, old));
  EXPECT_FALSE(store_->try_again(id, old, {"x", "y"}, 0ms, kAttempts));
  EXPECT_FALSE(store_->hand_back(id, old));
  EXPECT_EQ(state(id), JobState::Running);
  EXPECT_EQ(store_->find(id)->progress, 0);
  EXPECT_TRUE(store_->succeed(id, now, 1));
  EXPECT_FALSE(store_->succeed(id, now, 1));  // once
  EXPECT_EQ(store_->events(id, 0, 100).size(), 4U);
}

// Nobody else took it meanwhile: the worker was only slow.
TEST_F(ClaimTest, TakesAResultAfterALeaseThatNobodyTookUp) {
  const std::string id = queue();
  const auto claim = store_->claim("w1", kLease, kAttempts);
  time_.pass(kLease + 1h);
  EXPECT_TRUE(store_->succeed(id, claim->token, 1));
  const auto job = store_->find(id);
  EXPECT_EQ(job->state, JobState::Succeeded);
  EXPECT_EQ(job->progress, 1);
  EXPECT_EQ(job->token, claim->token);
}

TEST_F(ClaimTest, ParksAJobWhoseWorkersAllFellSilent) {
  const std::string id = queue();
  for (int i = 0; i < kAttempts; ++i) {
    ASSERT_TRUE(store_->claim("w", kLease, kAttempts));
    time_.pass(kLease);
  }
  EXPECT_FALSE(store_->claim("w", kLease, kAttempts));
  EXPECT_EQ(state(id), JobState::Dead);
  EXPECT_EQ(store_->find(id)->error->code, "worker_lost");
}

TEST_F(ClaimTest, ParksAJobWithTheReasonOfItsLastAttempt) {
  const std::string id = queue();
  for (int i = 1; i <= kAttempts; ++i) {
    const auto claim = store_->claim("w", kLease, kAttempts);
    ASSERT_TRUE(claim);
    const JobError error{"crashed", "attempt " + std::to_string(i)};
    EXPECT_TRUE(store_->try_again(id, claim->token, error, 0ms, kAttempts));
  }
  EXPECT_EQ(state(id), JobState::Dead);
  EXPECT_EQ(store_->find(id)->error->message, "attempt 3");
  EXPECT_FALSE(store_->claim("w", kLease, kAttempts));
}

TEST_F(ClaimTest, PausesBeforeAnotherTryAndSaysWhy) {
  const std::string id = queue();
  const auto claim = store_->claim("w", kLease, kAttempts);
  store_->try_again(id, claim->token, {"crashed", "SIGSEGV"}, 2s, kAttempts);
  EXPECT_EQ(state(id), JobState::Queued);
  EXPECT_EQ(store_->find(id)->error->message, "SIGSEGV");
  time_.pass(2s - 1ms);
  EXPECT_FALSE(store_->claim("w", kLease, kAttempts));
  time_.pass(1ms);
  const auto again = store_->claim("w", kLease, kAttempts);
  ASSERT_TRUE(again);
  store_->succeed(id, again->token, 1);
  EXPECT_FALSE(store_->find(id)->error);
}

TEST_F(ClaimTest, DoesNotCountAnAttemptThatIsHandedBack) {
  const std::string id = queue();
  for (int i = 0; i < 2 * kAttempts; ++i) {
    const auto claim = store_->claim("w", kLease, kAttempts);
    ASSERT_TRUE(claim);
    EXPECT_EQ(claim->job.attempts, 1);
    EXPECT_TRUE(store_->hand_back(id, claim->token));
  }
  EXPECT_EQ(state(id), JobState::Queued);
}

TEST_F(ClaimTest, TellsTheWorkerOfAJobToCancel) {
  const std::string id = queue();
  const auto claim = store_->claim("w", kLease, kAttempts);
  EXPECT_TRUE(store_->cancel(id)->cancel_wanted);
  EXPECT_EQ(state(id), JobState::Running);
  EXPECT_EQ(store_->heartbeat(id, claim->token, kLease), LeaseAnswer::Cancel);
  EXPECT_EQ(store_->progress(id, claim->token, 0.1, "fit", ""), LeaseAnswer::Cancel);
  EXPECT_TRUE(store_->cancelled(id, claim->token));
  EXPECT_EQ(state(id), JobState::Cancelled);
}

TEST_F(ClaimTest, NeverRunsAJobAgainThatWasToBeCancelled) {
  const std::string silent = queue(), crashed = queue(), returned = queue();
  store_->claim("w", kLease, kAttempts);
  const auto b = store_->claim("w", kLease, kAttempts), c = store_->claim("w", kLease, kAttempts);
  for (const std::string& id : {silent, crashed, returned}) store_->cancel(id);
  store_->try_again(crashed, b->token, {"crashed", ""}, 0ms, kAttempts);
  store_->hand_back(returned, c->token);
  time_.pass(kLease);
  EXPECT_FALSE(store_->claim("w", kLease, kAttempts));
  for (const std::string& id : {silent, crashed, returned}) {
    EXPECT_EQ(state(id), JobState::Cancelled) << id;
  }
}

TEST_F(ClaimTest, RemembersWhichWorkersLive) {
  store_->worker_alive("w1", "north");
  const JobTime start = time_.now();
  time_.pass(1min);
  store_->worker_alive("w1", "north");
  store_->worker_alive("w2", "south");
  ASSERT_EQ(store_->workers(time_.now()).size(), 2U);
  EXPECT_EQ(store_->workers(time_.now())[0].started, start);
  EXPECT_EQ(store_->workers(time_.now())[1].host, "south");
  store_->worker_gone("w2");
  EXPECT_EQ(store_->workers({}).size(), 1U);
  EXPECT_TRUE(store_->workers(time_.now() + 1ms).empty());
}

}  // namespace
}  // namespace regarment
