#pragma once

#include <span>

#include "jobs/sqlite_database.h"

namespace regarment {

/// What leads from schema N to N + 1 stands at place N; never changed once it was released.
std::span<const char* const> job_store_migrations();

/// Brings the file to the newest schema, all missing steps in one transaction; a file that has it
/// is only read. Throws UsageError, and changes nothing, when the file belongs to another program
/// or its schema is newer than `migrations` knows.
void migrate(SqliteDatabase& database, std::span<const char* const> migrations);

}  // namespace regarment
