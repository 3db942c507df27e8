#pragma once

#include <vector>

#include "service/access.h"
#include "service/metrics.h"
#include "service/route.h"
#include "service/service.h"

namespace regarment {

// The routes of the API, as schemas/openapi.json describes them. What is handed in outlives them.

/// /v1/jobs and all below it.
std::vector<Route> job_routes(const Service& service);

/// /v1/batches and /v1/evaluations.
std::vector<Route> batch_routes(const Service& service);

/// /v1/work: what a worker without the folder of the files asks for (jobs/server_files.h).
std::vector<Route> work_routes(const Service& service);

/// /v1/templates, /healthz, /readyz, /metrics, /version, /openapi.json.
std::vector<Route> fact_routes(const Service& service, const Metrics& metrics);

/// POST and DELETE /v1/session: the cookie of pages.
std::vector<Route> session_routes(Access& access);

/// The pages for browsers, given to everybody.
std::vector<Route> page_routes();

}  // namespace regarment
