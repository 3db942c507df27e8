#pragma once

#include <filesystem>
#include <memory>

#include "jobs/api_key.h"
#include "jobs/job.h"

namespace regarment {

/// A job to be queued. `id` names a folder that is already there.
struct NewJob {
  std::string id;
  JobKind kind = JobKind::Fit;
  std::string owner, batch, source, name;
  std::vector<std::string> garments;
  std::string options = "{}";
  std::uint64_t bytes = 0;
  std::string idempotency_key;  // of this owner; empty: none
  std::string body_sha256;      // what the key stands for
};

/// What became of it. `Existed`: the key was used before for the same body, `job` is that job, and
/// the new folder is of no use. `KeyClash`: the key was used for another body; `job` is that one.
struct Created {
  enum class Kind { Made, Existed, KeyClash };
  Kind kind = Kind::Made;
  Job job;
};

/// Which jobs to list; what is empty does not matter. Newest first.
struct JobFilter {
  std::vector<JobState> states = {};
  std::string text = {};  // part of name, id or garments, letter case aside (of ASCII letters)
  std::string batch = {}, owner = {}, source = {};
  std::optional<JobKind> kind = {};
  std::optional<Verdict> verdict = {};
  std::optional<bool> reviewed = {};
  int limit = 50;          // 1 to 500
  std::string after = {};  // `next` of the page before
};

struct JobPage {
  std::vector<Job> jobs;
  std::string next;  // empty: this was the last page
};

/// A job that a worker now has. `token` rises with every claim of the job: who comes back with an
/// older one is told that the job is no longer his.
struct Claim {
  Job job;
  std::int64_t token = 0;
};

/// What a worker hears when it speaks of its job. `Cancel`: end it and call `cancelled`. `Lost`: it
/// belongs to somebody else or is gone; end it and leave no trace.
enum class LeaseAnswer { Go, Cancel, Lost };

/// A worker process as it last said.
struct WorkerSeen {
  std::string id;    // unique, says host and process: "studio-3/4711-1a2b3c"
  std::string host;  // for people
  JobTime started, seen;
};

/// How the queue stands, for metrics and readiness.
struct QueueFacts {
  std::array<std::uint64_t, kJobStates.size()> jobs{};  // in the order of kJobStates
  std::optional<JobTime> oldest_queued;
  std::uint64_t bytes = 0;  // of all jobs
};

/// Where jobs, their events, reviews, batches and the API keys are kept, shared by servers and
/// workers. Any thread of any process may call anything; each call is one transaction, durable when
/// it returns. Times come from the clock the store was opened with, else from the database's
/// machine, so that leases hold between machines whose clocks differ. Calls that name something
/// that is not there answer empty or false. All throw TemporaryError when the store is away, locked
/// for too long, or its disk is full; then nothing of the call has happened. Text arguments may
/// hold any bytes but are no longer than 1 MiB (InvalidInput).
class JobStore {
 public:
  virtual ~JobStore() = default;

  // --- what the server does ---

  virtual Created create(const NewJob& job) = 0;
  virtual std::optional<Job> find(std::string_view id) = 0;
  virtual JobPage list(const JobFilter& filter) = 0;
  /// Events with a number above `after`, oldest first, at most `most`.
  virtual std::vector<JobEvent> events(std::string_view id, std::int64_t after, int most) = 0;
  /// The job as it is then: cancelled at once when it was queued; when running, `cancel_wanted`
  /// and soon cancelled by its worker; else unchanged.
  virtual std::optional<Job> cancel(std::string_view id) = 0;
  /// Queues a failed, cancelled or dead job again with all its attempts; else unchanged.
  virtual std::optional<Job> requeue(std::string_view id) = 0;
  /// Forgets the job in whatever state, with events, review and key, and the batch whose last job
  /// it was; its folder is for the caller to remove. A worker that has it learns it at its next
  /// heartbeat. False: no such job.
  virtual bool remove(std::string_view id) = 0;
  /// Keeps the verdict (an earlier one is replaced; its event stays). `time` is the store's. False:
  /// no such job, or it has not succeeded.
  virtual bool review(std::string_view id, const Review& review) = 0;
  /// Forgets the verdict; `by` is who takes it back (Review::by). An event tells it, where there
  /// was one. False: no such job, or it has not succeeded.
  virtual bool take_back_review(std::string_view id, std::string_view by) = 0;
  /// Jobs that ended before `moment`, oldest first.
  virtual std::vector<std::string> ended_before(JobTime moment, int most) = 0;
  /// Bytes of all jobs of one owner.
  virtual std::uint64_t bytes_of(std::string_view owner) = 0;
  /// Jobs of one owner that have not ended.
  virtual std::uint64_t open_jobs_of(std::string_view owner) = 0;
  /// Looks at every job; what is asked often has `queued_jobs`.
  virtual QueueFacts facts() = 0;
  /// How many jobs are queued, counted up to `most` and at the cost of these alone.
  virtual std::uint64_t queued_jobs(std::uint64_t most) = 0;
  /// Throws TemporaryError unless something can be written now.
  virtual void check_writable() = 0;
  virtual int schema_version() = 0;
  /// What the store takes for now: the time to compare its times with.
  virtual JobTime time() = 0;

  virtual Batch create_batch(std::string_view name, std::string_view owner) = 0;
  virtual std::optional<Batch> find_batch(std::string_view id) = 0;
  /// Newest first. `owner` empty: of all.
  virtual std::vector<Batch> batches(std::string_view owner, int most) = 0;

  // --- what a worker does ---

  /// The queued job that waits longest, or a running one whose lease is over. One whose lease is
  /// over for the `max_attempts`-th time is parked as dead on the way (code "worker_lost").
  virtual std::optional<Claim> claim(const std::string& worker, std::chrono::milliseconds lease,
                                     int max_attempts) = 0;
  /// "I have it still": the lease begins anew.
  virtual LeaseAnswer heartbeat(std::string_view id, std::int64_t token,
                                std::chrono::milliseconds lease) = 0;
  /// How far it is; an event. `detail` is a line for people. No heartbeat.
  virtual LeaseAnswer progress(std::string_view id, std::int64_t token, double fraction,
                               const std::string& stage, const std::string& detail) = 0;
  // Each of these ends the worker's part; false: the token is stale, and nothing was changed.
  virtual bool succeed(std::string_view id, std::int64_t token, std::uint64_t bytes) = 0;
  virtual bool fail(std::string_view id, std::int64_t token, const JobError& error) = 0;
  virtual bool cancelled(std::string_view id, std::int64_t token) = 0;
  /// The attempt crashed or met a temporary failure: queued again not before `pause` is over, or
  /// dead with this error when it was the `max_attempts`-th.
  virtual bool try_again(std::string_view id, std::int64_t token, const JobError& error,
                         std::chrono::milliseconds pause, int max_attempts) = 0;
  /// The worker must go: queued again, and the attempt does not count.
  virtual bool hand_back(std::string_view id, std::int64_t token) = 0;

  /// Notes that a worker lives (`started` of its first call stays); `workers` lists those seen
  /// since, `worker_gone` takes one out.
  virtual void worker_alive(const std::string& worker, const std::string& host) = 0;
  virtual void worker_gone(const std::string& worker) = 0;
  virtual std::vector<WorkerSeen> workers(JobTime since) = 0;

  // --- API keys ---

  /// `hash` is key_hash() of the secret; the secret itself is never stored. `created` is the
  /// store's time.
  virtual void add_key(const ApiKey& key, const std::string& hash) = 0;
  /// All, the revoked ones too, oldest first.
  virtual std::vector<ApiKey> keys() = 0;
  virtual std::optional<StoredKey> find_key(std::string_view id) = 0;
  /// False: no such key, or revoked before.
  virtual bool revoke_key(std::string_view id) = 0;
};

/// Opens the store that `where` names, and makes or migrates it: a path is an SQLite file (its
/// folder is made), "postgresql://..." a PostgreSQL database, whose schema "regarment" is ours.
/// Throws UsageError when `where` names no store of this build, the place is not writable, is
/// something else, or its schema is newer than this program; TemporaryError when it is away.
/// `clock` empty: see JobStore.
std::unique_ptr<JobStore> open_job_store(const std::string& where, JobClock clock = {});

/// `where` fit to be shown and logged: without the password of an address.
std::string shown_store(const std::string& where);

}  // namespace regarment
