#pragma once

#include "http/request.h"
#include "jobs/job_store.h"

namespace regarment {

/// Which jobs GET /v1/jobs asks for: state (several with commas), text, batch, source, kind,
/// verdict, reviewed (true or false), limit, after. Throws HttpProblem 400 "bad_parameter" naming
/// the parameter, also for one that is not known.
JobFilter read_filter(const Request& request);

}  // namespace regarment
