#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "jobs/job.h"
#include "jobs/job_folder.h"

namespace regarment {

class JobStore;

/// The command of the program that does a job, its result going to `folders.result(job)`: `program`
/// (absolute), the job's kind, options that tell how far it is as JSON, and what its prepared
/// inputs (job_inputs.h) are. Throws ReadError when its scan or table is not there, UsageError for
/// options that are none and for a `source` that has no result.
std::vector<std::string> job_command(const Job& job, const JobFolders& folders, JobStore& store,
                                     const std::filesystem::path& program, int threads);

/// What a fit calls the scan that its sender calls `name`: the last part of it as a path, of at
/// most 200 bytes. Empty: nothing that could be a file's name; the fit calls it as its file is
/// called.
std::string scan_name_of(const std::string& name);

}  // namespace regarment
