#pragma once

#include <string>
#include <vector>

#include "jobs/job.h"
#include "jobs/job_folder.h"

namespace regarment {

class JobStore;

/// Makes ready, in the folder of a job, what its command reads beside what was sent: the tables of
/// an evaluation of a batch. Throws as write_batch_tables does.
void prepare_inputs(const Job& job, const JobFolders& folders, JobStore& store);

/// The files that the command of a prepared job reads, as names below DATA/jobs, sorted:
/// "ID/scan.ply", "ID/scans/a.ply", and of a refit "SOURCE/result-2/state.bin". Throws as
/// `source_of`.
std::vector<std::string> job_inputs(const Job& job, const JobFolders& folders, JobStore& store);

/// The job whose result a refit begins from. Throws UsageError when it has none, or is deleted.
Job source_of(const Job& refit, JobStore& store);

}  // namespace regarment
