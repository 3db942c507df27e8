#pragma once

#include <span>

#include "jobs/sql_database.h"

namespace regarment {

/// What leads from schema N to N + 1 stands at place N; never changed once it was released.
std::span<const char* const> job_store_migrations();

/// Brings the database to the newest schema, all missing steps in one transaction; one that has it
/// is only read. Throws UsageError, and changes nothing, when the database belongs to another
/// program or its schema is newer than `migrations` knows.
void migrate(SqlDatabase& database, std::span<const char* const> migrations);

}  // namespace regarment
