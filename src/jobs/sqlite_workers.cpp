// What workers do: claims under a lease, and what ends them, each held to the claim's token.

#include "jobs/sqlite_rows.h"
#include "jobs/sqlite_store.h"

namespace regarment {
namespace {

using Lock = std::lock_guard<std::mutex>;

}  // namespace

// Asked often on an empty queue, and costs no write then.
bool SqliteJobStore::has_work() {
  const Lock lock(read_mutex_);
  SqliteStatement row(reader_,
                      "SELECT EXISTS (SELECT 1 FROM jobs WHERE state = 'queued' AND "
                      "not_before <= ?) OR EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND "
                      "lease_until <= ?)",
                      now(), now());
  row.step();
  return row.integer(0) != 0;
}

// Running jobs whose worker fell silent, and which nobody shall take up again.
void SqliteJobStore::park_lost_jobs(int max_attempts) {
  SqliteStatement lost(writer_,
                       "SELECT number, cancel_wanted, attempts FROM jobs WHERE state = 'running' "
                       "AND lease_until <= ? AND (cancel_wanted OR attempts >= ?)",
                       now(), max_attempts);
  std::vector<std::pair<std::int64_t, bool>> jobs;
  while (lost.step()) jobs.emplace_back(lost.integer(0), lost.integer(1) != 0);
  for (const auto& [job, cancel] : jobs) {
    if (cancel) {
      end_job(job, JobState::Cancelled, {});
    } else {
      end_job(job, JobState::Dead,
              {"worker_lost", "its worker fell silent " + std::to_string(max_attempts) +
                                  " times; see the workers' logs, then queue it again"});
    }
  }
}

std::optional<Claim> SqliteJobStore::claim(const std::string& worker,
                                           std::chrono::milliseconds lease, int max_attempts) {
  if (!has_work()) return std::nullopt;
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  park_lost_jobs(max_attempts);
  const std::int64_t moment = now();
  SqliteStatement row(
      writer_,
      "UPDATE jobs SET state = 'running', attempts = attempts + 1, token = token + 1, "
      "lease_until = ?, worker = ?, started = ?, progress = 0, stage = '' "
      "WHERE number = (SELECT min(number) FROM ("
      "SELECT min(number) AS number FROM jobs WHERE state = 'queued' AND not_before <= ? "
      "UNION ALL SELECT min(number) FROM jobs WHERE state = 'running' AND lease_until <= ?)) "
      "RETURNING " +
          std::string(kJobColumns) + ", number",
      moment + lease.count(), worker, moment, moment, moment);
  std::optional<Claim> claim;
  if (row.step()) {
    constexpr int kNumberColumn = 25;  // after kJobColumns
    const std::int64_t number = row.integer(kNumberColumn);
    Job job = job_of_row(row);
    row.run();
    add_event(number, "state", state_event(JobState::Running, job.attempts, {}));
    claim = Claim{job, job.token};
  }
  transaction.commit();
  return claim;
}

std::optional<std::int64_t> SqliteJobStore::job_under(std::string_view id, std::int64_t token) {
  SqliteStatement row(writer_,
                      "SELECT number FROM jobs WHERE id = ? AND token = ? AND state = 'running'",
                      id, token);
  if (!row.step()) return std::nullopt;
  return row.integer(0);
}

LeaseAnswer SqliteJobStore::answer_to(std::int64_t job) {
  SqliteStatement row(writer_, "SELECT cancel_wanted FROM jobs WHERE number = ?", job);
  return row.step() && row.integer(0) != 0 ? LeaseAnswer::Cancel : LeaseAnswer::Go;
}

LeaseAnswer SqliteJobStore::heartbeat(std::string_view id, std::int64_t token,
                                      std::chrono::milliseconds lease) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  const auto job = job_under(id, token);
  if (!job) return LeaseAnswer::Lost;
  SqliteStatement(writer_, "UPDATE jobs SET lease_until = ? WHERE number = ?",
                  now() + lease.count(), *job)
      .run();
  const LeaseAnswer answer = answer_to(*job);
  transaction.commit();
  return answer;
}

LeaseAnswer SqliteJobStore::progress(std::string_view id, std::int64_t token, double fraction,
                                     const std::string& stage, const std::string& detail) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  const auto job = job_under(id, token);
  if (!job) return LeaseAnswer::Lost;
  SqliteStatement(writer_, "UPDATE jobs SET progress = ?, stage = ? WHERE number = ?", fraction,
                  stage, *job)
      .run();
  add_event(*job, "progress", progress_event(fraction, stage, detail));
  const LeaseAnswer answer = answer_to(*job);
  transaction.commit();
  return answer;
}

bool SqliteJobStore::finish(std::string_view id, std::int64_t token, JobState state,
                            const JobError& error, std::uint64_t bytes) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  const auto job = job_under(id, token);
  if (!job) return false;
  if (bytes > 0) {
    SqliteStatement(writer_, "UPDATE jobs SET bytes = ? WHERE number = ?", bytes, *job).run();
  }
  end_job(*job, state, error);
  transaction.commit();
  return true;
}

bool SqliteJobStore::succeed(std::string_view id, std::int64_t token, std::uint64_t bytes) {
  return finish(id, token, JobState::Succeeded, {}, bytes);
}

bool SqliteJobStore::fail(std::string_view id, std::int64_t token, const JobError& error) {
  return finish(id, token, JobState::Failed, error, 0);
}

bool SqliteJobStore::cancelled(std::string_view id, std::int64_t token) {
  return finish(id, token, JobState::Cancelled, {}, 0);
}

bool SqliteJobStore::try_again(std::string_view id, std::int64_t token, const JobError& error,
                               std::chrono::milliseconds pause, int max_attempts) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  const auto job = job_under(id, token);
  if (!job) return false;
  SqliteStatement row(writer_,
                      "UPDATE jobs SET state = 'queued', not_before = ?, error_code = ?, "
                      "error_message = ?, progress = 0, stage = '' "
                      "WHERE number = ? RETURNING attempts, cancel_wanted",
                      now() + pause.count(), error.code, error.message, *job);
  row.step();
  const auto attempts = static_cast<int>(row.integer(0));
  const bool cancel = row.integer(1) != 0;
  row.run();
  if (cancel) {
    end_job(*job, JobState::Cancelled, {});
  } else if (attempts >= max_attempts) {
    end_job(*job, JobState::Dead, error);
  } else {
    add_event(*job, "state", state_event(JobState::Queued, attempts, error));
  }
  transaction.commit();
  return true;
}

bool SqliteJobStore::hand_back(std::string_view id, std::int64_t token) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  const auto job = job_under(id, token);
  if (!job) return false;
  if (answer_to(*job) == LeaseAnswer::Cancel) {
    end_job(*job, JobState::Cancelled, {});
  } else {
    SqliteStatement(writer_,
                    "UPDATE jobs SET state = 'queued', attempts = attempts - 1, not_before = 0, "
                    "progress = 0, stage = '' WHERE number = ?",
                    *job)
        .run();
    add_event(*job, "state", state_event(JobState::Queued, 0, {}));
  }
  transaction.commit();
  return true;
}

void SqliteJobStore::worker_alive(const std::string& worker, const std::string& host) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  SqliteStatement(writer_,
                  "INSERT INTO workers (id, host, started, seen) VALUES (?, ?, ?, ?) "
                  "ON CONFLICT (id) DO UPDATE SET seen = excluded.seen",
                  worker, host, now(), now())
      .run();
  transaction.commit();
}

void SqliteJobStore::worker_gone(const std::string& worker) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  SqliteStatement(writer_, "DELETE FROM workers WHERE id = ?", worker).run();
  transaction.commit();
}

std::vector<WorkerSeen> SqliteJobStore::workers(JobTime since) {
  const Lock lock(read_mutex_);
  SqliteStatement row(reader_,
                      "SELECT id, host, started, seen FROM workers WHERE seen >= ? ORDER BY id",
                      since.time_since_epoch().count());
  std::vector<WorkerSeen> workers;
  while (row.step()) {
    workers.push_back({row.text(0), row.text(1), time_of(row.integer(2)), time_of(row.integer(3))});
  }
  return workers;
}

}  // namespace regarment
