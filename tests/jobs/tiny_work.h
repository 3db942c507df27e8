#pragma once

#include <filesystem>
#include <string>

#include "jobs/job_store.h"
#include "jobs/worker.h"

// Jobs so small that what is measured is the store and the workers: their "program" is a shell
// script that copies the scan, which says which job it is.

namespace regarment {

/// Writes the script into the folder; its path.
std::filesystem::path write_tiny_program(const std::filesystem::path& folder);
/// The scan of job I.
std::string tiny_scan(int job);
/// Whether the result folder of job I is whole and its own.
bool is_tiny_result(const std::filesystem::path& result, int job);

}  // namespace regarment
