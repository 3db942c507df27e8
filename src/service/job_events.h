#pragma once

#include <cstdint>
#include <string>

#include "http/response.h"
#include "jobs/job_store.h"

namespace regarment {

/// The events of a job after number `after`, as they come. Ends when the job has ended and its
/// events are told, or when it is deleted.
class JobEvents : public EventStream {
 public:
  JobEvents(JobStore& store, std::string id, std::int64_t after);
  Part next() override;

 private:
  JobStore& store_;
  std::string id_;
  std::int64_t after_;
};

/// Where a request wants its events to begin: Last-Event-ID, else the query's `after`, else 0.
/// Throws HttpProblem 400 "bad_parameter" when that is no number.
std::int64_t last_event(const Request& request);

}  // namespace regarment
