#include "jobs/sqlite_store.h"

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "jobs/sqlite_rows.h"
#include "jobs/sqlite_schema.h"

namespace regarment {
namespace {

using Lock = std::lock_guard<std::mutex>;

std::string select_jobs(const std::string& rest) {
  return std::string("SELECT ") + kJobColumns + rest;
}

std::optional<Job> one_job(SqliteDatabase& database, std::string_view id) {
  SqliteStatement row(database, select_jobs("FROM jobs WHERE id = ?"), id);
  if (!row.step()) return std::nullopt;
  return job_of_row(row);
}

// The answer to a key that was used before.
std::optional<Created> earlier(SqliteDatabase& database, const NewJob& job) {
  if (job.idempotency_key.empty()) return std::nullopt;
  SqliteStatement row(database,
                      select_jobs(", body_sha256 FROM jobs WHERE owner = ? AND idempotency_key = ? "
                                  "AND idempotency_key <> ''"),
                      job.owner, job.idempotency_key);
  if (!row.step()) return std::nullopt;
  constexpr int kBodyColumn = 25;  // after kJobColumns
  const bool same = row.text(kBodyColumn) == job.body_sha256;
  return Created{same ? Created::Kind::Existed : Created::Kind::KeyClash, job_of_row(row)};
}

SqliteDatabase& migrated(SqliteDatabase& database) {
  migrate(database, job_store_migrations());
  return database;
}

}  // namespace

// The writer makes and migrates the file before the reader looks at it.
SqliteJobStore::SqliteJobStore(const std::filesystem::path& file, JobClock clock)
    : clock_(std::move(clock)), writer_(file), reader_(migrated(writer_).file()) {}

Created SqliteJobStore::create(const NewJob& job) {
  if (!is_job_id(job.id)) throw InvalidInput("create: '" + job.id + "' is no job id");
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  if (auto before = earlier(writer_, job)) return *before;
  SqliteStatement(writer_,
                  "INSERT INTO jobs (id, kind, state, owner, batch, source, name, garments, "
                  "options, created, bytes, idempotency_key, body_sha256) "
                  "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)",
                  job.id, name_of(job.kind), name_of(JobState::Queued), job.owner, job.batch,
                  job.source, job.name, garments_json(job.garments), job.options, now(), job.bytes,
                  job.idempotency_key, job.body_sha256)
      .run();
  add_event(writer_.number("SELECT last_insert_rowid()"), "state",
            state_event(JobState::Queued, 0, {}));
  Created made{Created::Kind::Made, *one_job(writer_, job.id)};
  transaction.commit();
  return made;
}

std::optional<Job> SqliteJobStore::find(std::string_view id) {
  const Lock lock(read_mutex_);
  return one_job(reader_, id);
}

std::vector<JobEvent> SqliteJobStore::events(std::string_view id, std::int64_t after, int most) {
  const Lock lock(read_mutex_);
  SqliteStatement row(reader_,
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

std::optional<Job> SqliteJobStore::cancel(std::string_view id) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  SqliteStatement waiting(writer_, "SELECT number FROM jobs WHERE id = ? AND state = 'queued'", id);
  if (waiting.step()) end_job(waiting.integer(0), JobState::Cancelled, {});
  SqliteStatement(writer_, "UPDATE jobs SET cancel_wanted = 1 WHERE id = ? AND state = 'running'",
                  id)
      .run();
  auto job = one_job(writer_, id);
  transaction.commit();
  return job;
}

std::optional<Job> SqliteJobStore::requeue(std::string_view id) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  SqliteStatement changed(
      writer_,
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
  auto job = one_job(writer_, id);
  transaction.commit();
  return job;
}

bool SqliteJobStore::remove(std::string_view id) {
  const Lock lock(write_mutex_);
  {
    SqliteTransaction transaction(writer_);
    SqliteStatement row(writer_, "DELETE FROM jobs WHERE id = ? RETURNING batch", id);
    if (!row.step()) return false;
    const std::string batch = row.text(0);
    row.run();
    SqliteStatement(writer_,
                    "DELETE FROM batches WHERE id = ? AND NOT EXISTS "
                    "(SELECT 1 FROM jobs WHERE batch = batches.id AND batch <> '')",
                    batch)
        .run();
    transaction.commit();
  }
  writer_.empty_log();
  return true;
}

bool SqliteJobStore::review(std::string_view id, const Review& review) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  SqliteStatement changed(writer_,
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

bool SqliteJobStore::take_back_review(std::string_view id, std::string_view by) {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  SqliteStatement row(writer_,
                      "SELECT number, verdict FROM jobs WHERE id = ? AND state = 'succeeded'", id);
  if (!row.step()) return false;
  if (row.text(1).empty()) return true;
  const std::int64_t job = row.integer(0);
  SqliteStatement(writer_,
                  "UPDATE jobs SET verdict = '', note = '', reviewer = '', reviewed = 0 "
                  "WHERE number = ?",
                  job)
      .run();
  add_event(job, "review", taken_back_event(by));
  transaction.commit();
  return true;
}

std::vector<std::string> SqliteJobStore::ended_before(JobTime moment, int most) {
  const Lock lock(read_mutex_);
  SqliteStatement row(reader_, "SELECT id FROM jobs WHERE ended < ? ORDER BY ended, number LIMIT ?",
                      moment.time_since_epoch().count(), std::max(0, most));
  std::vector<std::string> ids;
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

std::uint64_t SqliteJobStore::bytes_of(std::string_view owner) {
  const Lock lock(read_mutex_);
  SqliteStatement row(reader_, "SELECT coalesce(sum(bytes), 0) FROM jobs WHERE owner = ?", owner);
  row.step();
  return static_cast<std::uint64_t>(row.integer(0));
}

std::uint64_t SqliteJobStore::open_jobs_of(std::string_view owner) {
  const Lock lock(read_mutex_);
  SqliteStatement row(
      reader_, "SELECT count(*) FROM jobs WHERE owner = ? AND +state IN ('queued', 'running')",
      owner);
  row.step();
  return static_cast<std::uint64_t>(row.integer(0));
}

QueueFacts SqliteJobStore::facts() {
  const Lock lock(read_mutex_);
  QueueFacts facts;
  SqliteStatement row(reader_,
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

void SqliteJobStore::check_writable() {
  const Lock lock(write_mutex_);
  SqliteTransaction transaction(writer_);
  writer_.run("INSERT OR REPLACE INTO workers VALUES ('', '', 0, 0)");
  writer_.run("DELETE FROM workers WHERE id = ''");
  transaction.commit();
}

int SqliteJobStore::schema_version() {
  const Lock lock(read_mutex_);
  return static_cast<int>(reader_.number("PRAGMA user_version"));
}

void SqliteJobStore::add_event(std::int64_t job, std::string_view kind, const std::string& data) {
  SqliteStatement(writer_, "UPDATE jobs SET last_event = last_event + 1 WHERE number = ?", job)
      .run();
  SqliteStatement(writer_,
                  "INSERT INTO events (job, number, time, kind, data) "
                  "SELECT number, last_event, ?, ?, ? FROM jobs WHERE number = ?",
                  now(), kind, data, job)
      .run();
}

void SqliteJobStore::end_job(std::int64_t job, JobState state, const JobError& error) {
  SqliteStatement(writer_,
                  "UPDATE jobs SET state = ?, ended = ?, error_code = ?, error_message = ?, "
                  "progress = CASE ? WHEN 'succeeded' THEN 1 ELSE progress END WHERE number = ?",
                  name_of(state), now(), error.code, error.message, name_of(state), job)
      .run();
  SqliteStatement row(writer_, "SELECT attempts FROM jobs WHERE number = ?", job);
  row.step();
  add_event(job, "state", state_event(state, static_cast<int>(row.integer(0)), error));
}

}  // namespace regarment
