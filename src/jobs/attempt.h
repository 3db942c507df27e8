#pragma once

#include <functional>

#include "base/child_process.h"
#include "jobs/job_progress.h"
#include "jobs/job_store.h"
#include "jobs/worker.h"

namespace regarment {

/// How an attempt at a job came out, and what that means for it.
struct AttemptEnd {
  enum class Kind { Succeeded, Failed, TryAgain };
  Kind kind = Kind::Succeeded;
  JobError error;
};

/// What the end of its child says: the codes of worker.h.
AttemptEnd attempt_end(const ChildEnd& end, const WorkerOptions& options);

/// Does the job of a claim in a child process and tells the store what became of it, all under the
/// claim's token. `wanted` false: the job may take `grace` more, then it is handed back. Waits
/// while the store is away; when that is for longer than a lease, the job is left to whoever comes
/// next. Throws NoAccess once the job is handed back.
void run_attempt(const Claim& claim, JobStore& store, JobFiles& files, const WorkerOptions& options,
                 const std::function<bool()>& wanted);

}  // namespace regarment
