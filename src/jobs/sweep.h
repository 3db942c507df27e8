#pragma once

#include "jobs/job_folder.h"
#include "jobs/job_store.h"

namespace regarment {

struct Swept {
  int expired = 0;    // jobs deleted because they ended long ago
  int abandoned = 0;  // folders removed that belong to no job
};

/// Deletes jobs that ended more than `keep` ago (zero: none), with their folders, and removes what
/// crashes left among the uploads: folders on their way out, deliveries whose worker no longer has
/// the job, and uploads and job folders a day old or more of which the store knows nothing. At most
/// 1000 jobs a call. Throws TemporaryError when the store is away.
Swept sweep_data(JobStore& store, const JobFolders& folders, std::chrono::milliseconds keep,
                 JobTime now);

}  // namespace regarment
