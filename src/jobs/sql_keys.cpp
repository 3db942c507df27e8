// Batches and API keys.

#include <algorithm>

#include "base/error.h"
#include "jobs/sql_rows.h"
#include "jobs/sql_store.h"

namespace regarment {
namespace {

using Lock = std::lock_guard<std::mutex>;

constexpr const char* kBatchColumns = "SELECT id, name, owner, created FROM batches ";
constexpr const char* kKeyColumns = "SELECT id, name, scopes, hash, created, revoked FROM keys ";

// A row of kBatchColumns, with its jobs counted.
Batch batch_of(SqlDatabase& database, const SqlStatement& row) {
  Batch batch{row.text(0), row.text(1), row.text(2), time_of(row.integer(3)), {}};
  SqlStatement count(database,
                     "SELECT state, count(*) FROM jobs WHERE batch = ? AND batch <> '' "
                     "GROUP BY state",
                     batch.id);
  while (count.step()) {
    if (const auto state = job_state_named(count.text(0))) {
      batch.jobs[static_cast<std::size_t>(*state)] = static_cast<std::uint64_t>(count.integer(1));
    }
  }
  return batch;
}

}  // namespace

Batch SqlJobStore::create_batch(std::string_view name, std::string_view owner) {
  Batch batch{new_job_id(), std::string(name), std::string(owner), time_of(now()), {}};
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement(*writer_, "INSERT INTO batches (id, name, owner, created) VALUES (?, ?, ?, ?)",
               batch.id, batch.name, batch.owner, batch.created.time_since_epoch().count())
      .run();
  transaction.commit();
  return batch;
}

std::optional<Batch> SqlJobStore::find_batch(std::string_view id) {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_, std::string(kBatchColumns) + "WHERE id = ?", id);
  if (!row.step()) return std::nullopt;
  return batch_of(*reader_, row);
}

std::vector<Batch> SqlJobStore::batches(std::string_view owner, int most) {
  const Lock lock(read_mutex_);
  SqlStatement row(
      *reader_,
      std::string(kBatchColumns) + "WHERE (? = '' OR owner = ?) ORDER BY number DESC LIMIT ?",
      owner, owner, std::max(0, most));
  std::vector<Batch> batches;
  while (row.step()) batches.push_back(batch_of(*reader_, row));
  return batches;
}

void SqlJobStore::add_key(const ApiKey& key, const std::string& hash) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement(*writer_,
               "INSERT INTO keys (id, name, scopes, hash, created) VALUES (?, ?, ?, ?, ?)", key.id,
               key.name, scopes_text(key.scopes), hash, now())
      .run();
  transaction.commit();
}

std::vector<ApiKey> SqlJobStore::keys() {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_, std::string(kKeyColumns) + "ORDER BY number");
  std::vector<ApiKey> keys;
  while (row.step()) keys.push_back(key_of_row(row).key);
  return keys;
}

std::optional<StoredKey> SqlJobStore::find_key(std::string_view id) {
  const Lock lock(read_mutex_);
  SqlStatement row(*reader_, std::string(kKeyColumns) + "WHERE id = ?", id);
  if (!row.step()) return std::nullopt;
  return key_of_row(row);
}

bool SqlJobStore::revoke_key(std::string_view id) {
  const Lock lock(write_mutex_);
  SqlTransaction transaction(*writer_);
  SqlStatement row(*writer_,
                   "UPDATE keys SET revoked = ? WHERE id = ? AND revoked IS NULL RETURNING id",
                   now(), id);
  const bool revoked = row.step();
  if (revoked) row.run();
  transaction.commit();
  return revoked;
}

}  // namespace regarment
