#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jobs/job_folder.h"
#include "jobs/job_store.h"
#include "jobs/service_config.h"

namespace regarment {

/// What the routes work with. All of it outlives them, and any thread may use it.
struct Service {
  JobStore& store;
  const JobFolders& folders;
  const ServiceConfig& config;
  /// Throws UsageError when the program would not take these words (option_words) for a job of this
  /// kind with these garments.
  std::function<void(JobKind kind, const std::vector<std::string>& garments,
                     const std::vector<std::string>& words)>
      check_words;
};

/// The job, or HttpProblem 404 "no_such_job".
Job find_job(const Service& service, const std::string& id);

/// Throws HttpProblem when nothing more can be taken now: 429 "queue_full" and "too_many_jobs", 507
/// "no_space" and "quota_used_up". `owner`: a key's id, or empty.
void check_room(const Service& service, const std::string& owner);

/// Throws HttpProblem 422 "bad_options" when options are not known, or the program would not take
/// them for these garments.
void check_options(const Service& service, JobKind kind, const std::vector<std::string>& garments,
                   const std::string& options);

/// Template names from a JSON array, or from one or more names with commas. Throws HttpProblem 422
/// "bad_garments" for none, more than 8, or one that no template has.
std::vector<std::string> read_garments(const std::string& text);

}  // namespace regarment
