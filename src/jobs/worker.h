#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "jobs/job_files.h"
#include "jobs/job_store.h"
#include "jobs/service_config.h"

namespace regarment {

struct WorkerOptions {
  std::filesystem::path program;  // absolute: the program whose commands are run
  int threads = 1;                // of each fit
  std::chrono::milliseconds lease{30000};
  std::chrono::milliseconds poll{200};  // between two looks at an empty queue
  int max_attempts = 3;
  std::chrono::milliseconds pause{2000};    // before another try; doubled with each attempt
  std::uint64_t memory_mb = 4096;           // address space of a child; 0: no limit
  std::uint64_t file_mb = 2048;             // of any one file it writes
  std::chrono::milliseconds time{1800000};  // wall time of a child
  std::chrono::milliseconds grace{10000};   // what a running job may still take once asked to stop
  std::string host;                         // for people; empty: the machine's name
  bool until_empty = false;                 // return once nothing is queued

  static WorkerOptions from(const ServiceConfig& config);
};

/// Error codes of jobs:
///   unreadable_scan   no readable scan, or no person in it (exit status 3)
///   no_garment        a person, but not the garment, or no credible fit (4)
///   bad_request       options that contradict each other or the template (2)
///   internal          a fault of the program (1)
///   temporary         disk full and the like (75); tried again
///   crashed           ended by a signal; tried again
///   out_of_memory     ended for want of memory, or killed; tried again
///   timed_out         longer than it may take; tried again
///   worker_lost       its worker fell silent; tried again
/// What is tried again becomes `dead` with the last of these after `max_attempts`.

/// Runs jobs one after the other, each in a child process of its own, until `wanted` answers false:
/// then the running job may finish within `grace`, else it is handed back. A result folder appears
/// whole, and counts only when the store took it under this worker's token. Store failures are
/// waited out, and so is a server of files that is away; while one is, nothing is claimed. One call
/// per process at a time. Throws UsageError when the program is not there, and NoAccess.
void run_worker(JobStore& store, JobFiles& files, const WorkerOptions& options,
                const std::function<bool()>& wanted);

}  // namespace regarment
