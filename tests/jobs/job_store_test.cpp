// What every store does for the server.

#include <set>

#include "base/error.h"
#include "store_places.h"

namespace regarment {
namespace {

using namespace std::chrono_literals;

TEST_F(JobStoreTest, GivesBackWhatWasQueued) {
  NewJob given{
      new_job_id(),        JobKind::Refit,   "owner", "batch", "source", "a \"scan\" \xc3\xa9.ply",
      {"skirt", "tshirt"}, R"({"seed": 7})", 12345,   "key",   "body"};
  const Created made = store_->create(given);
  EXPECT_EQ(made.kind, Created::Kind::Made);
  const auto job = open_job_store(place_->where(), time_.clock())->find(given.id);
  ASSERT_TRUE(job);
  EXPECT_EQ(job->kind, JobKind::Refit);
  EXPECT_EQ(job->state, JobState::Queued);
  EXPECT_EQ(job->owner + "," + job->batch + "," + job->source, "owner,batch,source");
  EXPECT_EQ(job->name, given.name);
  EXPECT_EQ(job->garments, given.garments);
  EXPECT_EQ(job->options, given.options);
  EXPECT_EQ(job->bytes, 12345U);
  EXPECT_EQ(job->created, time_.now());
  EXPECT_FALSE(job->started || job->ended || job->error || job->review);
}

TEST_F(JobStoreTest, KeepsAnyBytesOfAText) {
  NewJob job;
  job.name = "\xf0\x9f\x91\x97 ?$1 \x1a\x1a \xed\xa0\x80";  // a dress; marks; half a pair
  for (int byte = 0; byte < 256; ++byte) job.name += static_cast<char>(byte);
  job.options = std::string(std::size_t{1} << 20U, 'x');
  const auto found = store_->find(queue(job));
  EXPECT_EQ(found->name, job.name);
  EXPECT_EQ(found->options, job.options);
  EXPECT_EQ(store_->list({.text = "\xf0\x9f\x91\x97 ?"}).jobs.size(), 1U);
  job.options += 'x';
  EXPECT_THROW(queue(job), InvalidInput);
}

TEST_F(JobStoreTest, KnowsNothingOfOtherIds) {
  EXPECT_FALSE(store_->find("nobody"));
  EXPECT_FALSE(store_->cancel("nobody"));
  EXPECT_FALSE(store_->requeue("nobody"));
  EXPECT_FALSE(store_->remove("nobody"));
  EXPECT_FALSE(store_->review("nobody", {}));
  EXPECT_TRUE(store_->events("nobody", 0, 10).empty());
  EXPECT_EQ(store_->heartbeat("nobody", 1, kLease), LeaseAnswer::Lost);
}

TEST_F(JobStoreTest, AnswersAKeyUsedTwiceWithTheFirstJob) {
  NewJob job;
  job.id = new_job_id(), job.owner = "a", job.idempotency_key = "k", job.body_sha256 = "1";
  ASSERT_EQ(store_->create(job).kind, Created::Kind::Made);
  NewJob again = job;
  again.id = new_job_id();
  const Created second = store_->create(again);
  EXPECT_EQ(second.kind, Created::Kind::Existed);
  EXPECT_EQ(second.job.id, job.id);
  EXPECT_FALSE(store_->find(again.id));
  again.body_sha256 = "2";
  EXPECT_EQ(store_->create(again).kind, Created::Kind::KeyClash);
  again.owner = "b";  // somebody else's key of the same name
  EXPECT_EQ(store_->create(again).kind, Created::Kind::Made);
}

TEST_F(JobStoreTest, ListsNewestFirstPageByPage) {
  std::vector<std::string> made(7);
  std::generate(made.begin(), made.end(), [&] { return queue(); });
  std::vector<std::string> listed;
  JobFilter filter;
  filter.limit = 3;
  int pages = 0;
  do {
    const JobPage page = store_->list(filter);
    for (const Job& job : page.jobs) listed.push_back(job.id);
    filter.after = page.next;
    queue();  // what comes in between does not move the pages that follow
    ++pages;
  } while (!filter.after.empty());
  EXPECT_EQ(pages, 3);
  EXPECT_EQ(listed, std::vector<std::string>(made.rbegin(), made.rend()));
}

TEST_F(JobStoreTest, ListsByWhatIsAskedFor) {
  NewJob one;
  one.name = "100%_done.ply", one.garments = {"skirt"}, one.batch = "b1", one.owner = "o1";
  const std::string a = queue(one);
  NewJob other;
  other.name = "1000 done.ply", other.kind = JobKind::Render, other.owner = "o2";
  const std::string b = queue(other);
  store_->cancel(b);
  const auto ids = [&](const JobFilter& filter) {
    std::set<std::string> out;
    for (const Job& job : store_->list(filter).jobs) out.insert(job.id);
    return out;
  };
  using Ids = std::set<std::string>;
  EXPECT_EQ(ids({}), (Ids{a, b}));
  EXPECT_EQ(ids({.states = {JobState::Cancelled}}), Ids{b});
  EXPECT_EQ(ids({.states = {JobState::Cancelled, JobState::Queued}}), (Ids{a, b}));
  EXPECT_EQ(ids({.states = {JobState::Dead}}), Ids{});
  EXPECT_EQ(ids({.text = "0%_D"}), Ids{a});  // no pattern, letter case aside
  EXPECT_EQ(ids({.text = "skirt"}), Ids{a});
  EXPECT_EQ(ids({.text = "SKIRT"}), Ids{a});
  EXPECT_EQ(ids({.text = b}), Ids{b});
  EXPECT_EQ(ids({.batch = "b1"}), Ids{a});
  EXPECT_EQ(ids({.owner = "o2"}), Ids{b});
  EXPECT_EQ(ids({.kind = JobKind::Render}), Ids{b});
  EXPECT_EQ(ids({.text = "done", .owner = "o1"}), Ids{a});
  EXPECT_THROW(ids({.limit = 0}), UsageError);
  EXPECT_THROW(ids({.limit = 501}), UsageError);
  EXPECT_THROW(ids({.after = "x"}), UsageError);
}

TEST_F(JobStoreTest, NumbersEventsFromOneAndReadsThemAfterANumber) {
  const std::string id = queue();
  const auto claim = store_->claim("w", kLease, kAttempts);
  store_->progress(id, claim->token, 0.25, "measure", "edge 1 of 4");
  store_->succeed(id, claim->token, 10);
  store_->review(id, {Verdict::Rejected, "too \"wide\"", "me", {}});
  const auto events = store_->events(id, 0, 100);
  ASSERT_EQ(events.size(), 5U);
  const char* data[] = {R"({"state":"queued","attempt":0})", R"({"state":"running","attempt":1})",
                        R"({"progress":0.25,"stage":"measure","detail":"edge 1 of 4"})",
                        R"({"state":"succeeded","attempt":1})",
                        R"({"verdict":"rejected","note":"too \"wide\"","by":"me"})"};
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].number, static_cast<std::int64_t>(i + 1));
    EXPECT_EQ(events[i].data, data[i]);
  }
  EXPECT_EQ(events[2].kind + events[3].kind + events[4].kind, "progressstatereview");
  EXPECT_EQ(store_->events(id, 3, 100).size(), 2U);
  EXPECT_EQ(store_->events(id, 1, 2).size(), 2U);
  EXPECT_EQ(store_->events(id, 1, 2).front().number, 2);
}

TEST_F(JobStoreTest, CancelsAQueuedJobAtOnceAndForGood) {
  const std::string id = queue();
  time_.pass(5s);
  const auto job = store_->cancel(id);
  EXPECT_EQ(job->state, JobState::Cancelled);
  EXPECT_EQ(job->ended, time_.now());
  EXPECT_FALSE(store_->claim("w", kLease, kAttempts));
  EXPECT_EQ(store_->cancel(id)->state, JobState::Cancelled);
  EXPECT_EQ(store_->events(id, 0, 10).size(), 2U);
}

TEST_F(JobStoreTest, QueuesAnEndedJobAgainWithAllItsAttempts) {
  const std::string id = queue();
  const auto claim = store_->claim("w", kLease, kAttempts);
  store_->fail(id, claim->token, {"no_garment", "no skirt"});
  EXPECT_EQ(store_->find(id)->error->code, "no_garment");
  EXPECT_EQ(store_->requeue(id)->state, JobState::Queued);
  EXPECT_FALSE(store_->find(id)->error);
  const auto again = store_->claim("w", kLease, kAttempts);
  EXPECT_EQ(again->job.attempts, 1);
  EXPECT_GT(again->token, claim->token);
  store_->succeed(id, again->token, 1);
  EXPECT_EQ(store_->requeue(id)->state, JobState::Succeeded);
}

TEST_F(JobStoreTest, ForgetsARemovedJobAltogether) {
  NewJob job;
  job.id = new_job_id(), job.idempotency_key = "k", job.bytes = 100;
  const std::string batch = job.batch = store_->create_batch("trial", "").id;
  store_->create(job);
  const auto claim = store_->claim("w", kLease, kAttempts);
  EXPECT_TRUE(store_->remove(job.id));
  EXPECT_FALSE(store_->find(job.id));
  EXPECT_TRUE(store_->events(job.id, 0, 10).empty());
  EXPECT_FALSE(store_->find_batch(batch));
  EXPECT_EQ(store_->facts().bytes, 0U);
  EXPECT_EQ(store_->heartbeat(job.id, claim->token, kLease), LeaseAnswer::Lost);
  EXPECT_FALSE(store_->succeed(job.id, claim->token, 1));
  EXPECT_EQ(store_->create(job).kind, Created::Kind::Made);
  EXPECT_EQ(store_->events(job.id, 0, 10).size(), 1U);
}

TEST_F(JobStoreTest, KeepsTheLastVerdictOfASucceededJobOnly) {
  const std::string id = queue();
  EXPECT_FALSE(store_->review(id, {Verdict::Accepted, "", "", {}}));
  const auto claim = store_->claim("w", kLease, kAttempts);
  store_->succeed(id, claim->token, 1);
  EXPECT_EQ(store_->list({.reviewed = false}).jobs.size(), 1U);
  EXPECT_TRUE(store_->review(id, {Verdict::Unsure, "look", "a", {}}));
  time_.pass(1s);
  EXPECT_TRUE(store_->review(id, {Verdict::Accepted, "", "b", {}}));
  const auto review = store_->find(id)->review;
  EXPECT_EQ(review->verdict, Verdict::Accepted);
  EXPECT_EQ(review->note + review->by, "b");
  EXPECT_EQ(review->time, time_.now());
  EXPECT_TRUE(store_->list({.reviewed = false}).jobs.empty());
  EXPECT_EQ(store_->list({.verdict = Verdict::Accepted}).jobs.size(), 1U);
}

TEST_F(JobStoreTest, TakesAVerdictBackAndSaysSoOnce) {
  const std::string id = queue();
  EXPECT_FALSE(store_->take_back_review(id, "me"));
  EXPECT_FALSE(store_->take_back_review("nobody", "me"));
  const auto claim = store_->claim("w", kLease, kAttempts);
  store_->succeed(id, claim->token, 1);
  store_->review(id, {Verdict::Rejected, "too wide", "me", {}});
  EXPECT_TRUE(store_->take_back_review(id, "you"));
  EXPECT_FALSE(store_->find(id)->review);
  EXPECT_EQ(store_->list({.reviewed = false}).jobs.size(), 1U);
  EXPECT_TRUE(store_->list({.verdict = Verdict::Rejected}).jobs.empty());
  EXPECT_TRUE(store_->take_back_review(id, "you"));
  const auto events = store_->events(id, 3, 100);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].kind, "review");
  EXPECT_EQ(events[1].data, R"({"verdict":null,"note":"","by":"you"})");
  EXPECT_TRUE(store_->review(id, {Verdict::Accepted, "", "", {}}));
  EXPECT_EQ(store_->find(id)->review->note, "");
}

TEST_F(JobStoreTest, CountsTheQueueNoFurtherThanAsked) {
  EXPECT_EQ(store_->queued_jobs(3), 0U);
  for (int i = 0; i < 5; ++i) queue();
  EXPECT_EQ(store_->queued_jobs(3), 3U);
  EXPECT_EQ(store_->queued_jobs(5), 5U);
  ASSERT_TRUE(store_->claim("w", kLease, kAttempts));
  EXPECT_EQ(store_->queued_jobs(1000), 4U);
}

TEST_F(JobStoreTest, CountsAndSumsPerStateAndOwner) {
  NewJob job;
  job.owner = "a", job.bytes = 10;
  queue(job);
  time_.pass(1min);
  job.owner = "b", job.bytes = 200;
  queue(job);
  const auto claim = store_->claim("w", kLease, kAttempts);
  const std::string cancelled = queue(job);
  store_->cancel(cancelled);
  const QueueFacts facts = store_->facts();
  const auto count = [&](JobState s) { return facts.jobs[static_cast<std::size_t>(s)]; };
  EXPECT_EQ(count(JobState::Queued), 1U);
  EXPECT_EQ(count(JobState::Running), 1U);
  EXPECT_EQ(count(JobState::Cancelled), 1U);
  EXPECT_EQ(facts.oldest_queued, time_.now());
  EXPECT_EQ(facts.bytes, 410U);
  EXPECT_EQ(store_->queued_jobs(10), 1U);
  EXPECT_EQ(store_->bytes_of("b"), 400U);
  EXPECT_EQ(store_->open_jobs_of("b"), 1U);
  EXPECT_EQ(store_->open_jobs_of("a"), 1U);
  store_->succeed(claim->job.id, claim->token, 1000);
  EXPECT_EQ(store_->bytes_of("a"), 1000U);
  EXPECT_EQ(store_->open_jobs_of("a"), 0U);
}

TEST_F(JobStoreTest, NamesJobsThatEndedLongAgo) {
  const std::string old = queue();
  store_->cancel(old);
  time_.pass(1h);
  store_->cancel(queue());
  queue();
  EXPECT_EQ(store_->ended_before(time_.now(), 10), std::vector<std::string>{old});
  EXPECT_TRUE(store_->ended_before(time_.now(), 0).empty());
  EXPECT_EQ(store_->ended_before(time_.now() + 1ms, 10).size(), 2U);
}

TEST_F(JobStoreTest, CountsTheJobsOfABatch) {
  NewJob job;
  const Batch batch = store_->create_batch("spring", "o");
  job.batch = batch.id;
  queue(job), queue(job), queue();
  store_->claim("w", kLease, kAttempts);
  const auto found = store_->find_batch(batch.id);
  EXPECT_EQ(found->name + found->owner, "springo");
  EXPECT_EQ(found->jobs, (decltype(found->jobs){1, 1, 0, 0, 0, 0}));
  const Batch second = store_->create_batch("autumn", "p");
  EXPECT_EQ(store_->batches("", 10).front().id, second.id);
  EXPECT_EQ(store_->batches("", 1).size(), 1U);
  EXPECT_EQ(store_->batches("o", 10).size(), 1U);
}

TEST_F(JobStoreTest, CanBeWritten) {
  EXPECT_NO_THROW(store_->check_writable());
  EXPECT_TRUE(store_->workers({}).empty());
  EXPECT_GE(store_->schema_version(), 1);
}

}  // namespace
}  // namespace regarment
