#include "jobs/sqlite_schema.h"

#include <array>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr std::int64_t kApplication = 0x52474d54;  // "RGMT"

// Times are milliseconds since 1970, UTC.
constexpr const char* kFirst = R"sql(
CREATE TABLE jobs (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  kind TEXT NOT NULL,
  state TEXT NOT NULL,
  owner TEXT NOT NULL,
  batch TEXT NOT NULL,
  source TEXT NOT NULL,
  name TEXT NOT NULL,
  garments TEXT NOT NULL,
  options TEXT NOT NULL,
  created INTEGER NOT NULL,
  started INTEGER,
  ended INTEGER,
  progress REAL NOT NULL DEFAULT 0,
  stage TEXT NOT NULL DEFAULT '',
  attempts INTEGER NOT NULL DEFAULT 0,
  token INTEGER NOT NULL DEFAULT 0,
  not_before INTEGER NOT NULL DEFAULT 0,
  lease_until INTEGER NOT NULL DEFAULT 0,
  worker TEXT NOT NULL DEFAULT '',
  cancel_wanted INTEGER NOT NULL DEFAULT 0,
  error_code TEXT NOT NULL DEFAULT '',
  error_message TEXT NOT NULL DEFAULT '',
  bytes INTEGER NOT NULL DEFAULT 0,
  verdict TEXT NOT NULL DEFAULT '',
  note TEXT NOT NULL DEFAULT '',
  reviewer TEXT NOT NULL DEFAULT '',
  reviewed INTEGER NOT NULL DEFAULT 0,
  idempotency_key TEXT NOT NULL DEFAULT '',
  body_sha256 TEXT NOT NULL DEFAULT '',
  last_event INTEGER NOT NULL DEFAULT 0
);
CREATE UNIQUE INDEX jobs_by_key ON jobs (owner, idempotency_key) WHERE idempotency_key <> '';
CREATE INDEX jobs_by_state ON jobs (state, number);
CREATE INDEX jobs_by_batch ON jobs (batch, number) WHERE batch <> '';
CREATE INDEX jobs_by_owner ON jobs (owner, number);
CREATE INDEX jobs_leased ON jobs (lease_until) WHERE state = 'running';
CREATE INDEX jobs_ended ON jobs (ended) WHERE ended IS NOT NULL;
CREATE TABLE events (
  job INTEGER NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  number INTEGER NOT NULL,
  time INTEGER NOT NULL,
  kind TEXT NOT NULL,
  data TEXT NOT NULL,
  PRIMARY KEY (job, number)
) WITHOUT ROWID;
CREATE TABLE batches (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  owner TEXT NOT NULL,
  created INTEGER NOT NULL
);
CREATE TABLE workers (
  id TEXT PRIMARY KEY,
  host TEXT NOT NULL,
  started INTEGER NOT NULL,
  seen INTEGER NOT NULL
) WITHOUT ROWID;
CREATE TABLE keys (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  scopes TEXT NOT NULL,
  hash TEXT NOT NULL,
  created INTEGER NOT NULL,
  revoked INTEGER
);
)sql";

constexpr std::array kMigrations = {kFirst};

std::int64_t version_of(SqliteDatabase& database) { return database.number("PRAGMA user_version"); }

// An empty file is nobody's yet.
void check_owner(SqliteDatabase& database) {
  if (database.number("PRAGMA application_id") == kApplication) return;
  if (database.number("SELECT count(*) FROM sqlite_master") == 0 && version_of(database) == 0) {
    return;
  }
  throw UsageError(one_line(database.file().string(), 300) +
                   ": an SQLite file of another program; name another --store");
}

void check_version(SqliteDatabase& database, std::int64_t known) {
  const std::int64_t found = version_of(database);
  if (found <= known) return;
  throw UsageError(one_line(database.file().string(), 300) + ": a job store of schema " +
                   std::to_string(found) + ", and this program knows schemas up to " +
                   std::to_string(known) + "; use the newer regarment that made it");
}

}  // namespace

std::span<const char* const> job_store_migrations() { return kMigrations; }

void migrate(SqliteDatabase& database, std::span<const char* const> migrations) {
  const auto newest = static_cast<std::int64_t>(migrations.size());
  check_owner(database);
  check_version(database, newest);
  database.share();
  if (version_of(database) == newest) return;
  SqliteTransaction transaction(database);
  check_version(database, newest);  // somebody may have been faster
  for (auto step = version_of(database); step < newest; ++step) {
    database.run(migrations[static_cast<std::size_t>(step)]);
  }
  database.run("PRAGMA application_id=" + std::to_string(kApplication));
  database.run("PRAGMA user_version=" + std::to_string(newest));
  transaction.commit();
}

}  // namespace regarment
