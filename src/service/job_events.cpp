#include "service/job_events.h"

#include <algorithm>
#include <charconv>

#include "service/job_json.h"

namespace regarment {

JobEvents::JobEvents(JobStore& store, std::string id, std::int64_t after)
    : store_(store), id_(std::move(id)), after_(after) {}

EventStream::Part JobEvents::next() {
  constexpr int kMost = 200;
  // Before the events: what comes after the end is none of this job's doing.
  const std::optional<Job> job = store_.find(id_);
  Part part;
  if (!job) return {"event: deleted\ndata: {}\n\n", true};
  const std::vector<JobEvent> events = store_.events(id_, after_, kMost);
  for (const JobEvent& event : events) {
    part.bytes += event_text(event);
    after_ = std::max(after_, event.number);
  }
  part.ended = has_ended(job->state) && events.size() < kMost;
  return part;
}

std::int64_t last_event(const Request& request) {
  std::string_view text = request.headers.get("Last-Event-ID");
  const auto after = request.query.find("after");
  if (text.empty() && after != request.query.end()) text = after->second;
  if (text.empty()) return 0;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0)
    throw HttpProblem(400, "bad_parameter", "Last-Event-ID: not the number of an event");
  return number;
}

}  // namespace regarment
