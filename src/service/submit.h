#pragma once

#include "service/service.h"
#include "service/upload.h"

namespace regarment {

/// Begins POST /v1/jobs: checks that there is room before the body is taken.
std::unique_ptr<Exchange> begin_job(const Service& service, const Call& call);

/// Begins POST /v1/evaluations: a table of truth and its scans.
std::unique_ptr<Exchange> begin_evaluation(const Service& service, const Call& call);

/// Begins POST /v1/batches/{id}/evaluation: the finished fits of `batch`, which is the caller's to
/// see, beside their truth; nothing is fitted again.
std::unique_ptr<Exchange> begin_batch_evaluation(const Service& service, const Call& call,
                                                 const Batch& batch);

/// POST /v1/jobs/{id}/refit: the result of a job fitted again with other options, as a new job.
Response submit_refit(const Service& service, const Call& call);

/// Recognises the scan that was sent as the part `name` by its first bytes and its sender's name
/// for it, and moves it to `to` plus the extension its kind has. Throws HttpProblem 415
/// "unknown_format" or 422 "empty_scan".
void place_scan(const Upload& upload, const std::string& name, const std::filesystem::path& to);

/// Queues an uploaded or folderless job, and answers 202 with its Location; for an Idempotency-Key
/// that was used before, with the job that it made then, or 422 "key_used".
Response queue_job(const Service& service, NewJob job, Upload& upload, const Request& request);

}  // namespace regarment
