#pragma once

#include <functional>
#include <mutex>

#include "jobs/job_store.h"
#include "jobs/sql_database.h"

namespace regarment {

/// The JobStore in the tables of a database. One connection writes and one reads, so that a reader
/// does not wait for a writer's disk.
class SqlJobStore : public JobStore {
 public:
  /// `connect` gives a new connection each time. Throws as open_job_store does.
  SqlJobStore(const std::function<std::unique_ptr<SqlDatabase>()>& connect, JobClock clock);

  Created create(const NewJob& job) override;
  std::optional<Job> find(std::string_view id) override;
  JobPage list(const JobFilter& filter) override;
  std::vector<JobEvent> events(std::string_view id, std::int64_t after, int most) override;
  std::optional<Job> cancel(std::string_view id) override;
  std::optional<Job> requeue(std::string_view id) override;
  bool remove(std::string_view id) override;
  bool review(std::string_view id, const Review& review) override;
  bool take_back_review(std::string_view id, std::string_view by) override;
  std::vector<std::string> ended_before(JobTime moment, int most) override;
  std::uint64_t bytes_of(std::string_view owner) override;
  std::uint64_t open_jobs_of(std::string_view owner) override;
  QueueFacts facts() override;
  std::uint64_t queued_jobs(std::uint64_t most) override;
  void check_writable() override;
  int schema_version() override;
  JobTime time() override { return clock_ ? clock_() : writer_->now(); }

  Batch create_batch(std::string_view name, std::string_view owner) override;
  std::optional<Batch> find_batch(std::string_view id) override;
  std::vector<Batch> batches(std::string_view owner, int most) override;

  std::optional<Claim> claim(const std::string& worker, std::chrono::milliseconds lease,
                             int max_attempts) override;
  LeaseAnswer heartbeat(std::string_view id, std::int64_t token,
                        std::chrono::milliseconds lease) override;
  LeaseAnswer progress(std::string_view id, std::int64_t token, double fraction,
                       const std::string& stage, const std::string& detail) override;
  bool succeed(std::string_view id, std::int64_t token, std::uint64_t bytes) override;
  bool fail(std::string_view id, std::int64_t token, const JobError& error) override;
  bool cancelled(std::string_view id, std::int64_t token) override;
  bool try_again(std::string_view id, std::int64_t token, const JobError& error,
                 std::chrono::milliseconds pause, int max_attempts) override;
  bool hand_back(std::string_view id, std::int64_t token) override;

  void worker_alive(const std::string& worker, const std::string& host) override;
  void worker_gone(const std::string& worker) override;
  std::vector<WorkerSeen> workers(JobTime since) override;

  void add_key(const ApiKey& key, const std::string& hash) override;
  std::vector<ApiKey> keys() override;
  std::optional<StoredKey> find_key(std::string_view id) override;
  bool revoke_key(std::string_view id) override;

 private:
  std::int64_t now() { return time().time_since_epoch().count(); }
  // Within a transaction: adds the next event of a job, or the one with the number it was given.
  void add_event(std::int64_t job, std::string_view kind, const std::string& data);
  void add_event(std::int64_t job, std::int64_t number, std::string_view kind,
                 const std::string& data);
  void park_lost_jobs(int max_attempts);
  bool has_work();
  /// A running job whose claim has the token.
  struct Held {
    std::int64_t number;
    bool cancel;  // is wanted
  };
  std::optional<Held> held_under(std::string_view id, std::int64_t token);
  bool finish(std::string_view id, std::int64_t token, JobState state, const JobError& error,
              std::uint64_t bytes);
  void end_job(std::int64_t job, JobState state, const JobError& error);

  JobClock clock_;
  std::mutex write_mutex_, read_mutex_;
  std::unique_ptr<SqlDatabase> writer_, reader_;
};

}  // namespace regarment
