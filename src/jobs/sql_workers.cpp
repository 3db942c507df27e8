// What workers do: claims under a lease, and what ends them, each held to the claim's token.

#include "jobs/sql_rows.h"
#include "jobs/sql_store.h"

namespace regarment {
namespace {

using Lock = std::lock_guard<std::mutex>;

}  // namespace

// Asked often on an empty queue, and costs no write then.
bool SqlJobStore::has_work() {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_,
                   "SELECT CASE WHEN EXISTS (SELECT 1 FROM jobs WHERE state = 'queued' AND "
                   "not_before <= ?) OR EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND "
                   "lease_until <= ?) THEN 1 ELSE 0 END",
                   now(), now());
  row.step();
  return row.integer(0) != 0;
}

// Running jobs whose worker fell silent, and which nobody shall take up again.
void SqlJobStore::park_lost_jobs(int max_attempts) {
  SqlStatement lost(*writer_,
                    std::string("SELECT number, cancel_wanted FROM jobs WHERE state = 'running' "
                                "AND lease_until <= ? AND (cancel_wanted <> 0 OR attempts >= ?)") +
                        writer_->locking_free_ones(),
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

std::optional<Claim> SqlJobStore::claim(const std::string& worker, std::chrono::milliseconds lease,
                                        int max_attempts) {
  if (!has_work()) return std::nullopt;
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  park_lost_jobs(max_attempts);
  const std::int64_t moment = now();
  const std::string first = std::string(" ORDER BY number LIMIT 1") + writer_->locking_free_ones();
  SqlStatement row(
      *writer_,
      "UPDATE jobs SET state = 'running', attempts = attempts + 1, token = token + 1, "
      "lease_until = ?, worker = ?, started = ?, progress = 0, stage = '', "
      "last_event = last_event + 1 WHERE number = (SELECT min(number) FROM ("
      "SELECT number FROM (SELECT number FROM jobs WHERE state = 'queued' AND not_before <= ?" +
          first +
          ") AS waiting UNION ALL SELECT number FROM "
          "(SELECT number FROM jobs WHERE state = 'running' AND lease_until <= ?" +
          first + ") AS lost) AS free) RETURNING " + std::string(kJobColumns) +
          ", number, last_event",
      moment + lease.count(), worker, moment, moment, moment);
  std::optional<Claim> claim;
  if (row.step()) {
    constexpr int kNumberColumn = 25;  // after kJobColumns
    const std::int64_t number = row.integer(kNumberColumn);
    const std::int64_t event = row.integer(kNumberColumn + 1);
    Job job = job_of_row(row);
    row.run();
    add_event(number, event, "state", state_event(JobState::Running, job.attempts, {}));
    claim = Claim{job, job.token};
  }
  transaction.commit();
  return claim;
}

std::optional<SqlJobStore::Held> SqlJobStore::held_under(std::string_view id, std::int64_t token) {
  SqlStatement row(*writer_,
                   std::string("SELECT number, cancel_wanted FROM jobs WHERE id = ? AND token = ? "
                               "AND state = 'running'") +
                       writer_->locking(),
                   id, token);
  if (!row.step()) return std::nullopt;
  return Held{row.integer(0), row.integer(1) != 0};
}

LeaseAnswer SqlJobStore::heartbeat(std::string_view id, std::int64_t token,
                                   std::chrono::milliseconds lease) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  const auto held = held_under(id, token);
  if (!held) return LeaseAnswer::Lost;
  SqlStatement(*writer_, "UPDATE jobs SET lease_until = ? WHERE number = ?", now() + lease.count(),
               held->number)
      .run();
  transaction.commit();
  return held->cancel ? LeaseAnswer::Cancel : LeaseAnswer::Go;
}

LeaseAnswer SqlJobStore::progress(std::string_view id, std::int64_t token, double fraction,
                                  const std::string& stage, const std::string& detail) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  const auto held = held_under(id, token);
  if (!held) return LeaseAnswer::Lost;
  SqlStatement(*writer_, "UPDATE jobs SET progress = ?, stage = ? WHERE number = ?", fraction,
               stage, held->number)
      .run();
  add_event(held->number, "progress", progress_event(fraction, stage, detail));
  transaction.commit();
  return held->cancel ? LeaseAnswer::Cancel : LeaseAnswer::Go;
}

bool SqlJobStore::finish(std::string_view id, std::int64_t token, JobState state,
                         const JobError& error, std::uint64_t bytes) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  const auto held = held_under(id, token);
  if (!held) return false;
  if (bytes > 0) {
    SqlStatement(*writer_, "UPDATE jobs SET bytes = ? WHERE number = ?", bytes, held->number).run();
  }
  end_job(held->number, state, error);
  transaction.commit();
  return true;
}

bool SqlJobStore::succeed(std::string_view id, std::int64_t token, std::uint64_t bytes) {
  return finish(id, token, JobState::Succeeded, {}, bytes);
}

bool SqlJobStore::fail(std::string_view id, std::int64_t token, const JobError& error) {
  return finish(id, token, JobState::Failed, error, 0);
}

bool SqlJobStore::cancelled(std::string_view id, std::int64_t token) {
  return finish(id, token, JobState::Cancelled, {}, 0);
}

bool SqlJobStore::try_again(std::string_view id, std::int64_t token, const JobError& error,
                            std::chrono::milliseconds pause, int max_attempts) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  const auto held = held_under(id, token);
  if (!held) return false;
  SqlStatement row(*writer_,
                   "UPDATE jobs SET state = 'queued', not_before = ?, error_code = ?, "
                   "error_message = ?, progress = 0, stage = '' "
                   "WHERE number = ? RETURNING attempts",
                   now() + pause.count(), error.code, error.message, held->number);
  row.step();
  const auto attempts = static_cast<int>(row.integer(0));
  row.run();
  if (held->cancel) {
    end_job(held->number, JobState::Cancelled, {});
  } else if (attempts >= max_attempts) {
    end_job(held->number, JobState::Dead, error);
  } else {
    add_event(held->number, "state", state_event(JobState::Queued, attempts, error));
  }
  transaction.commit();
  return true;
}

bool SqlJobStore::hand_back(std::string_view id, std::int64_t token) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  const auto held = held_under(id, token);
  if (!held) return false;
  if (held->cancel) {
    end_job(held->number, JobState::Cancelled, {});
  } else {
    SqlStatement(*writer_,
                 "UPDATE jobs SET state = 'queued', attempts = attempts - 1, not_before = 0, "
                 "progress = 0, stage = '' WHERE number = ?",
                 held->number)
        .run();
    add_event(held->number, "state", state_event(JobState::Queued, 0, {}));
  }
  transaction.commit();
  return true;
}

void SqlJobStore::worker_alive(const std::string& worker, const std::string& host) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement(*writer_,
               "INSERT INTO workers (id, host, started, seen) VALUES (?, ?, ?, ?) "
               "ON CONFLICT (id) DO UPDATE SET seen = excluded.seen",
               worker, host, now(), now())
      .run();
  transaction.commit();
}

void SqlJobStore::worker_gone(const std::string& worker) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement(*writer_, "DELETE FROM workers WHERE id = ?", worker).run();
  transaction.commit();
}

std::vector<WorkerSeen> SqlJobStore::workers(JobTime since) {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_,
                   "SELECT id, host, started, seen FROM workers WHERE seen >= ? ORDER BY id",
                   since.time_since_epoch().count());
  std::vector<WorkerSeen> workers;
  while (row.step()) {
    workers.push_back({row.text(0), row.text(1), time_of(row.integer(2)), time_of(row.integer(3))});
  }
  return workers;
}

}  // namespace regarment
