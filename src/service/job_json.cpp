#include "service/job_json.h"

#include <nlohmann/json.hpp>

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

Json when(const std::optional<JobTime>& time) { return time ? Json(rfc3339(*time)) : Json(); }

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json error_of(const Job& job) {
  if (!job.error) return {};
  return {{"code", job.error->code}, {"message", job.error->message}};
}

Json review_of(const Job& job) {
  if (!job.review) return {};
  return {{"verdict", name_of(job.review->verdict)},
          {"note", job.review->note},
          {"by", or_null(job.review->by)},
          {"time", rfc3339(job.review->time)}};
}

Json links_of(const Job& job) {
  const std::string self = "/v1/jobs/" + job.id;
  Json out = {{"self", self}, {"events", self + "/events"}};
  if (job.state == JobState::Succeeded && job.kind != JobKind::Render)
    out["report"] = self + "/report";
  return out;
}

Json object_of(const Job& job) {
  return {{"id", job.id},
          {"kind", name_of(job.kind)},
          {"state", name_of(job.state)},
          {"progress", job.progress},
          {"stage", or_null(job.stage)},
          {"error", error_of(job)},
          {"name", job.name},
          {"garments", job.garments},
          {"options", Json::parse(job.options, nullptr, false)},
          {"batch", or_null(job.batch)},
          {"source", or_null(job.source)},
          {"created", rfc3339(job.created)},
          {"started", when(job.started)},
          {"ended", when(job.ended)},
          {"attempts", job.attempts},
          {"cancel_wanted", job.cancel_wanted},
          {"review", review_of(job)},
          {"bytes", job.bytes},
          {"links", links_of(job)}};
}

Json object_of(const Batch& batch) {
  Json jobs = Json::object();
  for (std::size_t i = 0; i < kJobStates.size(); ++i)
    jobs[std::string(name_of(kJobStates[i]))] = batch.jobs[i];
  return {{"id", batch.id},
          {"name", batch.name},
          {"created", rfc3339(batch.created)},
          {"jobs", jobs},
          {"links", {{"self", "/v1/batches/" + batch.id}, {"jobs", "/v1/jobs?batch=" + batch.id}}}};
}

// Names come from outside and may be any bytes.
std::string text_of(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string job_json(const Job& job, const std::vector<std::string>& files) {
  Json json = object_of(job);
  json["files"] = files;
  return text_of(json) + "\n";
}

std::string page_json(const JobPage& page) {
  Json jobs = Json::array();
  for (const Job& job : page.jobs) jobs.push_back(object_of(job));
  return text_of({{"jobs", jobs}, {"next", or_null(page.next)}}) + "\n";
}

std::string batch_json(const Batch& batch) { return text_of(object_of(batch)) + "\n"; }

std::string batches_json(const std::vector<Batch>& batches) {
  Json list = Json::array();
  for (const Batch& batch : batches) list.push_back(object_of(batch));
  return text_of({{"batches", list}}) + "\n";
}

std::string event_text(const JobEvent& event) {
  Json data = Json::parse(event.data, nullptr, false);
  if (!data.is_object()) data = Json::object();
  data["time"] = rfc3339(event.time);
  // One line, whatever the data: JSON escapes line ends.
  return "id: " + std::to_string(event.number) + "\nevent: " + event.kind +
         "\ndata: " + text_of(data, -1) + "\n\n";
}

}  // namespace regarment
