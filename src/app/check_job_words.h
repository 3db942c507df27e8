#pragma once

#include <string>
#include <vector>

#include "jobs/job.h"

namespace regarment {

/// Throws UsageError when `fit` or `refit` would not take these option words for these garments,
/// before any scan is read. Other kinds of job take no options.
void check_job_words(JobKind kind, const std::vector<std::string>& garments,
                     const std::vector<std::string>& words);

}  // namespace regarment
