#pragma once

#include <filesystem>

#include "jobs/job.h"
#include "jobs/job_folder.h"

namespace regarment {

class JobStore;

/// What an evaluation of a batch compares, as tables (evaluation/estimates.h) in the job's folder.
struct BatchTables {
  std::filesystem::path truth, results;
};

/// Writes what the finished fits of the batch `job.batch` found, each scan under the name its
/// sender gave it and with the address of its report. Of several results of one name the newest
/// counts, so that a corrected scan counts as it was corrected. The truth is `truth.csv` in the
/// job's folder where somebody sent one, else what the scans themselves came with. Results that are
/// deleted meanwhile are left out. Throws UsageError when there is no result, or no truth.
BatchTables write_batch_tables(const Job& job, const JobFolders& folders, JobStore& store);

/// Where these lie once they are written.
BatchTables batch_tables(const Job& job, const JobFolders& folders);

}  // namespace regarment
