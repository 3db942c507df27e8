#pragma once

#include <string>

#include "jobs/job_store.h"

namespace regarment {

/// A job as the API shows it (schemas/openapi.json, Job). `files`: what its result holds.
std::string job_json(const Job& job, const std::vector<std::string>& files);

/// {"jobs": [...], "next": TEXT or null}; the jobs without their files.
std::string page_json(const JobPage& page);

std::string batch_json(const Batch& batch);
/// {"batches": [...]}
std::string batches_json(const std::vector<Batch>& batches);

/// An event as a server-sent one: id, event, data and an empty line.
std::string event_text(const JobEvent& event);

}  // namespace regarment
