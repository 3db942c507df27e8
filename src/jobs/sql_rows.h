#pragma once

#include <string>

#include "jobs/api_key.h"
#include "jobs/job.h"
#include "jobs/job_store.h"
#include "jobs/sql_database.h"

// How rows of the tables become our types, and back.

namespace regarment {

/// What job_of_row reads, in its order, as text for a SELECT from `jobs`.
extern const char* const kJobColumns;
Job job_of_row(const SqlStatement& row);

/// `id, name, scopes, hash, created, revoked` of `keys`.
StoredKey key_of_row(const SqlStatement& row);
std::string scopes_text(const std::vector<Scope>& scopes);

JobTime time_of(std::int64_t milliseconds);
std::string garments_json(const std::vector<std::string>& garments);

/// The data of an event: {"state", "attempt", "error"?: {"code", "message"}}; {"progress", "stage",
/// "detail"?}; {"verdict", "note", "by"}.
std::string state_event(JobState state, int attempt, const JobError& error);
std::string progress_event(double fraction, const std::string& stage, const std::string& detail);
std::string review_event(const Review& review);
std::string taken_back_event(std::string_view by);

}  // namespace regarment
