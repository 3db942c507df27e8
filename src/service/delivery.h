#pragma once

#include "service/route.h"
#include "service/service.h"

namespace regarment {

// How the result of a job comes from a worker: file by file into a folder of its own, then, once
// all are there, to its place in one step. All of it needs the claim to hold: HttpProblem 409
// "not_held" otherwise.

/// The job of a path /v1/work/{id}/..., which a worker has under the token of the query. Throws
/// HttpProblem 400 "bad_parameter", 404 "no_such_job", 409 "not_held".
Job held_job(const Service& service, const Call& call);

/// Begins PUT /v1/work/{id}/result/{file...}?token=N&sha256=HEX. The file is there once all of it
/// came and has that hash (422 "wrong_hash"). Throws 400 "bad_name", 413 "too_large" beyond
/// fit_file_mb, 507 "no_space".
std::unique_ptr<Exchange> begin_delivery(const Service& service, const Call& call);

/// POST /v1/work/{id}/result?token=N with {"files": [{"name", "bytes"}]}: makes exactly these files
/// the result, and answers {"bytes"} of the job; again with the same answer when it was done
/// before. Throws 409 "incomplete" when other files are there.
Response commit_delivery(const Service& service, const Call& call);

}  // namespace regarment
