#include "jobs/sql_store.h"

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "jobs/sql_rows.h"
#include "jobs/store_schema.h"

namespace regarment {
namespace {

using Lock = std::lock_guard<std::mutex>;

std::string select_jobs(const std::string& rest) {
  return std::string("SELECT ") + kJobColumns + rest;
}

std::optional<Job> one_job(SqlDatabase& database, std::string_view id) {
  SqlStatement row(database, select_jobs("FROM jobs WHERE id = ?"), id);
  if (!row.step()) return std::nullopt;
  return job_of_row(row);
}

// The answer to a key that was used before.
std::optional<Created> earlier(SqlDatabase& database, const NewJob& job) {
  if (job.idempotency_key.empty()) return std::nullopt;
  SqlStatement row(database,
                   select_jobs(", body_sha256 FROM jobs WHERE owner = ? AND idempotency_key = ? "
                               "AND idempotency_key <> ''"),
                   job.owner, job.idempotency_key);
  if (!row.step()) return std::nullopt;
  constexpr int kBodyColumn = 25;  // after kJobColumns
  const bool same = row.text(kBodyColumn) == job.body_sha256;
  return Created{same ? Created::Kind::Existed : Created::Kind::KeyClash, job_of_row(row)};
}

}  // namespace

// The writer makes and migrates the tables before the reader looks at them.
SqlJobStore::SqlJobStore(const std::function<std::unique_ptr<SqlDatabase>()>& connect,
                         JobClock clock)
    : clock_(std::move(clock)), writer_(connect()) {
  migrate(*writer_, job_store_migrations());
  reader_ = connect();
}

Created SqlJobStore::create(const NewJob& job) {
  if (!is_job_id(job.id)) throw InvalidInput("create: '" + job.id + "' is no job id");
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  for (;;) {
    if (auto before = earlier(*writer_, job)) return *before;
    SqlStatement row(*writer_,
                     "INSERT INTO jobs (id, kind, state, owner, batch, source, name, garments, "
                     "options, created, bytes, idempotency_key, body_sha256, last_event) "
                     "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,1) ON CONFLICT (owner, idempotency_key) "
                     "WHERE idempotency_key <> '' DO NOTHING RETURNING number",
                     job.id, name_of(job.kind), name_of(JobState::Queued), job.owner, job.batch,
                     job.source, job.name, garments_json(job.garments), job.options, now(),
                     job.bytes, job.idempotency_key, job.body_sha256);
    if (!row.step()) continue;  // somebody used the key just now
    const std::int64_t number = row.integer(0);
    row.run();
    add_event(number, 1, "state", state_event(JobState::Queued, 0, {}));
    break;
  }
  Created made{Created::Kind::Made, *one_job(*writer_, job.id)};
  transaction.commit();
  return made;
}

std::optional<Job> SqlJobStore::find(std::string_view id) {
  const Lock lock(read_mutex_);
  return one_job(*reader_, id);
}

std::vector<JobEvent> SqlJobStore::events(std::string_view id, std::int64_t after, int most) {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_,
                   "SELECT events.number, time, events.kind, data FROM events "
                   "JOIN jobs ON jobs.number = events.job "
                   "WHERE jobs.id = ? AND events.number > ? ORDER BY events.number LIMIT ?",
                   id, after, std::max(0, most));
  std::vector<JobEvent> events;
  while (row.step()) {
    events.push_back({row.integer(0), time_of(row.integer(1)), row.text(2), row.text(3)});
  }
  return events;
}

std::optional<Job> SqlJobStore::cancel(std::string_view id) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement row(*writer_,
                   std::string("SELECT number, state FROM jobs WHERE id = ?") + writer_->locking(),
                   id);
  if (!row.step()) return std::nullopt;
  const std::int64_t number = row.integer(0);
  const auto state = job_state_named(row.text(1));
  row.run();
  if (state == JobState::Queued) {
    end_job(number, JobState::Cancelled, {});
  } else if (state == JobState::Running) {
    SqlStatement(*writer_, "UPDATE jobs SET cancel_wanted = 1 WHERE number = ?", number).run();
  }
  auto job = one_job(*writer_, id);
  transaction.commit();
  return job;
}

std::optional<Job> SqlJobStore::requeue(std::string_view id) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement changed(
      *writer_,
      "UPDATE jobs SET state = 'queued', attempts = 0, not_before = 0, cancel_wanted = 0, "
      "progress = 0, stage = '', started = NULL, ended = NULL, error_code = '', "
      "error_message = '' WHERE id = ? AND state IN ('failed', 'cancelled', 'dead') "
      "RETURNING number",
      id);
  if (changed.step()) {
    const std::int64_t job = changed.integer(0);
    changed.run();
    add_event(job, "state", state_event(JobState::Queued, 0, {}));
  }
  auto job = one_job(*writer_, id);
  transaction.commit();
  return job;
}

bool SqlJobStore::remove(std::string_view id) {
  const Lock lock(write_mutex_);
  {
    SqlTransaction transaction(*writer_);
    SqlStatement row(*writer_, "DELETE FROM jobs WHERE id = ? RETURNING batch", id);
    if (!row.step()) return false;
    const std::string batch = row.text(0);
    row.run();
    // Held, so that of two that remove the last two jobs the second sees what the first did.
    SqlStatement(*writer_, std::string("SELECT id FROM batches WHERE id = ?") + writer_->locking(),
                 batch)
        .run();
    SqlStatement(*writer_,
                 "DELETE FROM batches WHERE id = ? AND NOT EXISTS "
                 "(SELECT 1 FROM jobs WHERE batch = batches.id AND batch <> '')",
                 batch)
        .run();
    transaction.commit();
  }
  writer_->wipe_deleted();
  return true;
}

bool SqlJobStore::review(std::string_view id, const Review& review) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement changed(*writer_,
                       "UPDATE jobs SET verdict = ?, note = ?, reviewer = ?, reviewed = ? "
                       "WHERE id = ? AND state = 'succeeded' RETURNING number",
                       name_of(review.verdict), review.note, review.by, now(), id);
  if (!changed.step()) return false;
  const std::int64_t job = changed.integer(0);
  changed.run();
  add_event(job, "review", review_event(review));
  transaction.commit();
  return true;
}

bool SqlJobStore::take_back_review(std::string_view id, std::string_view by) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement row(
      *writer_,
      std::string("SELECT number, verdict FROM jobs WHERE id = ? AND state = 'succeeded'") +
          writer_->locking(),
      id);
  if (!row.step()) return false;
  if (row.text(1).empty()) return true;
  const std::int64_t job = row.integer(0);
  row.run();
  SqlStatement(*writer_,
               "UPDATE jobs SET verdict = '', note = '', reviewer = '', reviewed = 0 "
               "WHERE number = ?",
               job)
      .run();
  add_event(job, "review", taken_back_event(by));
  transaction.commit();
  return true;
}

std::vector<std::string> SqlJobStore::ended_before(JobTime moment, int most) {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_, "SELECT id FROM jobs WHERE ended < ? ORDER BY ended, number LIMIT ?",
                   moment.time_since_epoch().count(), std::max(0, most));
  std::vector<std::string> ids;
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

std::uint64_t SqlJobStore::bytes_of(std::string_view owner) {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_, "SELECT coalesce(sum(bytes), 0) FROM jobs WHERE owner = ?", owner);
  row.step();
  return static_cast<std::uint64_t>(row.integer(0));
}

std::uint64_t SqlJobStore::open_jobs_of(std::string_view owner) {
  const Lock lock(read_mutex_);
  // coalesce: the index of the state is the better one, for jobs that have ended pile up.
  SqlStatement row(
      *reader_,
      "SELECT count(*) FROM jobs WHERE coalesce(owner, '') = ? AND state IN ('queued', 'running')",
      owner);
  row.step();
  return static_cast<std::uint64_t>(row.integer(0));
}

QueueFacts SqlJobStore::facts() {
  const Lock lock(read_mutex_);
  QueueFacts facts;
  SqlStatement row(*reader_,
                   "SELECT state, count(*), min(created), sum(bytes) FROM jobs GROUP BY state");
  while (row.step()) {
    const auto state = job_state_named(row.text(0));
    if (!state) continue;
    facts.jobs[static_cast<std::size_t>(*state)] = static_cast<std::uint64_t>(row.integer(1));
    if (state == JobState::Queued) facts.oldest_queued = time_of(row.integer(2));
    facts.bytes += static_cast<std::uint64_t>(row.integer(3));
  }
  return facts;
}

std::uint64_t SqlJobStore::queued_jobs(std::uint64_t most) {
  const Lock lock(read_mutex_);
  SqlStatement row(
      *reader_,
      "SELECT count(*) FROM (SELECT 1 FROM jobs WHERE state = 'queued' LIMIT ?) AS waiting", most);
  row.step();
  return static_cast<std::uint64_t>(row.integer(0));
}

void SqlJobStore::check_writable() {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  writer_->run(
      "INSERT INTO workers (id, host, started, seen) VALUES ('', '', 0, 0) "
      "ON CONFLICT (id) DO UPDATE SET seen = 0");
  writer_->run("DELETE FROM workers WHERE id = ''");
  transaction.commit();
}

int SqlJobStore::schema_version() {
  const Lock lock(read_mutex_);
  return reader_->schema_version();
}

void SqlJobStore::add_event(std::int64_t job, std::string_view kind, const std::string& data) {
  SqlStatement row(*writer_,
                   "UPDATE jobs SET last_event = last_event + 1 WHERE number = ? "
                   "RETURNING last_event",
                   job);
  row.step();
  const std::int64_t number = row.integer(0);
  row.run();
  add_event(job, number, kind, data);
}

void SqlJobStore::add_event(std::int64_t job, std::int64_t number, std::string_view kind,
                            const std::string& data) {
  SqlStatement(*writer_, "INSERT INTO events (job, number, time, kind, data) VALUES (?,?,?,?,?)",
               job, number, now(), kind, data)
      .run();
}

void SqlJobStore::end_job(std::int64_t job, JobState state, const JobError& error) {
  SqlStatement row(*writer_,
                   "UPDATE jobs SET state = ?, ended = ?, error_code = ?, error_message = ?, "
                   "progress = CASE ? WHEN 'succeeded' THEN 1 ELSE progress END, "
                   "last_event = last_event + 1 WHERE number = ? RETURNING attempts, last_event",
                   name_of(state), now(), error.code, error.message, name_of(state), job);
  row.step();
  const auto attempts = static_cast<int>(row.integer(0));
  const std::int64_t number = row.integer(1);
  row.run();
  add_event(job, number, "state", state_event(state, attempts, error));
}

}  // namespace regarment
