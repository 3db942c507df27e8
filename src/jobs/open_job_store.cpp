#include "base/error.h"
#include "base/one_line.h"
#include "jobs/postgres_database.h"
#include "jobs/sql_store.h"
#include "jobs/sqlite_database.h"

namespace regarment {
namespace {

// "//" makes an address; a file may hold any other characters.
std::string kind_of_address(const std::string& where) {
  const auto end = where.find("://");
  return end == std::string::npos ? "" : one_line(where.substr(0, end), 40);
}

}  // namespace

std::unique_ptr<JobStore> open_job_store(const std::string& where, JobClock clock) {
  if (where.empty()) {
    throw UsageError("--store: the value is empty; give a file, or postgresql://...");
  }
  if (is_postgres_address(where)) {
    const PostgresAddress address = PostgresAddress::parse(where);
    return std::make_unique<SqlJobStore>(
        [&] { return std::make_unique<PostgresDatabase>(address); }, std::move(clock));
  }
  if (const std::string kind = kind_of_address(where); !kind.empty()) {
    throw UsageError("--store: this build knows no store of the kind '" + kind +
                     "'; give the path of an SQLite file, or postgresql://...");
  }
  return std::make_unique<SqlJobStore>([&] { return std::make_unique<SqliteDatabase>(where); },
                                       std::move(clock));
}

std::string shown_store(const std::string& where) {
  const std::string kind = kind_of_address(where);
  if (kind.empty()) return where;
  try {
    if (is_postgres_address(where)) return PostgresAddress::parse(where).shown;
  } catch (const UsageError&) {
    // Opening it says what is wrong.
  }
  return kind + "://...";
}

}  // namespace regarment
