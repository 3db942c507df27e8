#include "base/error.h"
#include "base/one_line.h"
#include "jobs/sqlite_store.h"

namespace regarment {

std::unique_ptr<JobStore> open_job_store(const std::string& where, JobClock clock) {
  if (where.empty()) throw UsageError("--store: the value is empty; give a file");
  // "//" makes an address; a file may hold any other characters.
  if (where.find("://") != std::string::npos) {
    throw UsageError("--store: this build knows no store of the kind '" +
                     one_line(where.substr(0, where.find("://")), 40) +
                     "'; give the path of an SQLite file");
  }
  return std::make_unique<SqliteJobStore>(where, std::move(clock));
}

}  // namespace regarment
