#include "jobs/store_schema.h"

#include <array>

#include "base/error.h"

namespace regarment {
namespace {

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

void check_version(const SqlDatabase& database, int found, int known) {
  if (found <= known) return;
  throw UsageError(database.name() + ": a job store of schema " + std::to_string(found) +
                   ", and this program knows schemas up to " + std::to_string(known) +
                   "; use the newer regarment that made it");
}

}  // namespace

std::span<const char* const> job_store_migrations() { return kMigrations; }

void migrate(SqlDatabase& database, std::span<const char* const> migrations) {
  const auto newest = static_cast<int>(migrations.size());
  check_version(database, database.schema_version(), newest);
  database.share();
  if (database.schema_version() == newest) return;
  SqlTransaction transaction(database);
  database.lock_schema();
  const int found = database.schema_version();  // somebody may have been faster
  check_version(database, found, newest);
  for (int step = found; step < newest; ++step) {
    database.run(migrations[static_cast<std::size_t>(step)]);
  }
  database.set_schema_version(newest);
  transaction.commit();
}

}  // namespace regarment
