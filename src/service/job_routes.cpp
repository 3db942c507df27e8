#include <nlohmann/json.hpp>

#include "jobs/file_names.h"
#include "pages/verdict_json.h"
#include "report/files.h"
#include "report/result.h"
#include "service/job_events.h"
#include "service/job_json.h"
#include "service/query.h"
#include "service/result_files.h"
#include "service/routes.h"
#include "service/submit.h"

namespace regarment {
namespace {

constexpr std::uint64_t kMostJson = 64U << 10U;
constexpr std::size_t kLongestNote = 4000;
constexpr const char* kJson = "application/json";

// A job that the caller may not see is one that is not there.
Job visible_job(const Service& service, const Call& call) {
  Job job = find_job(service, call.captured.at(0));
  if (!call.caller.may_see(job))
    throw HttpProblem(404, "no_such_job", "there is no job of this id; GET /v1/jobs lists them");
  return job;
}

Job own_job(const Service& service, const Call& call) {
  Job job = visible_job(service, call);
  if (!call.caller.may_change(job))
    throw HttpProblem(403, "not_yours", "this key may not change this job");
  return job;
}

bool has_report(JobKind kind) { return kind == JobKind::Fit || kind == JobKind::Refit; }

std::vector<std::string> files_of(const Service& service, const Job& job) {
  if (job.state != JobState::Succeeded) return {};
  return file_names(service.folders.result(job));
}

Response answer_job(const Service& service, const Call& call, const Job& job, int status = 200) {
  Response out = text_response(status, kJson, job_json(job, files_of(service, job)));
  if (call.request.method != "GET") return out;
  out.headers.add("Cache-Control", "private, no-cache");
  return with_etag(call.request, std::move(out));
}

Response list_jobs(const Service& service, const Call& call) {
  JobFilter filter = read_filter(call.request);
  if (!call.caller.may(Scope::Read) && !call.caller.may(Scope::Review))
    filter.owner = call.caller.key.id;
  return text_response(200, kJson, page_json(service.store.list(filter)));
}

Response follow_events(const Service& service, const Call& call) {
  const Job job = visible_job(service, call);
  Response out = text_response(200, "text/event-stream", "");
  out.headers.add("X-Accel-Buffering", "no");  // a proxy must hand them on at once
  out.events = std::make_unique<JobEvents>(service.store, job.id, last_event(call.request));
  return out;
}

Response send_file(const Service& service, const Call& call,
                   const std::vector<std::string>& segments) {
  const Job job = visible_job(service, call);
  if (job.state != JobState::Succeeded)
    throw HttpProblem(404, "no_result",
                      "the job is " + std::string(name_of(job.state)) + " and has no result");
  return result_file(call.request, service.folders.result(job), segments);
}

Response send_report(const Service& service, const Call& call) {
  const Job job = visible_job(service, call);
  return send_file(service, call,
                   {job.kind == JobKind::Evaluate ? "evaluation.html" : "report.html"});
}

// The lights of the report, made of the result as they are there.
Response send_verdict(const Service& service, const Call& call) {
  const Job job = visible_job(service, call);
  constexpr std::size_t kMostResult = 16U << 20U;
  if (job.state != JobState::Succeeded || !has_report(job.kind))
    throw HttpProblem(404, "no_result", "the job has no result that could be judged");
  const std::filesystem::path file = service.folders.result(job) / "result.json";
  Response out = text_response(
      200, kJson, verdict_json(parse_result(read_file(file, kMostResult), "result.json")));
  out.headers.add("Cache-Control", "private, no-cache");
  return with_etag(call.request, std::move(out));
}

Response cancel_job(const Service& service, const Call& call) {
  const Job job = own_job(service, call);
  if (has_ended(job.state))
    throw HttpProblem(409, "has_ended",
                      "the job is " + std::string(name_of(job.state)) + " already");
  service.store.cancel(job.id);
  return answer_job(service, call, find_job(service, job.id), 202);
}

Response requeue_job(const Service& service, const Call& call) {
  const Job job = own_job(service, call);
  if (!has_ended(job.state) || job.state == JobState::Succeeded)
    throw HttpProblem(409, "not_over", "only a failed, cancelled or dead job can be queued again");
  check_room(service, call.caller.key.id);
  service.store.requeue(job.id);
  return answer_job(service, call, find_job(service, job.id), 202);
}

Response delete_job(const Service& service, const Call& call) {
  const Job job = own_job(service, call);
  service.store.remove(job.id);
  service.folders.remove(job.id);
  return text_response(204, "", "");
}

Review read_review(const Call& call) {
  const nlohmann::json body = nlohmann::json::parse(call.body, nullptr, false);
  const auto text = [&](const char* name) {
    return body.is_object() && body.contains(name) && body[name].is_string()
               ? body[name].get<std::string>()
               : std::string();
  };
  const std::optional<Verdict> verdict = verdict_named(text("verdict"));
  if (!verdict)
    throw HttpProblem(422, "bad_verdict",
                      "the body must be {\"verdict\": \"accepted\", \"rejected\" or \"unsure\", "
                      "\"note\": TEXT}");
  if (text("note").size() > kLongestNote)
    throw HttpProblem(422, "bad_verdict", "note: more than 4000 bytes; write less");
  return {*verdict, text("note"), call.caller.key.id, {}};
}

Response review_job(const Service& service, const Call& call) {
  const Job job = visible_job(service, call);
  if (!service.store.review(job.id, read_review(call)))
    throw HttpProblem(409, "no_result", "only a job that succeeded can be reviewed");
  return answer_job(service, call, find_job(service, job.id));
}

Response take_back_review(const Service& service, const Call& call) {
  const Job job = visible_job(service, call);
  if (!service.store.take_back_review(job.id, call.caller.key.id))
    throw HttpProblem(409, "no_result", "only a job that succeeded has a verdict");
  return answer_job(service, call, find_job(service, job.id));
}

}  // namespace

std::vector<Route> job_routes(const Service& s) {
  // Handlers outlive this call: they hold the service, which outlives them.
  const auto with = [&s](Response (*answer)(const Service&, const Call&)) {
    return [&s, answer](const Call& call) { return answer(s, call); };
  };
  std::vector<Route> out = {
      {"GET", "/v1/jobs", {}, with(list_jobs)},
      {"GET",
       "/v1/jobs/{id}",
       {},
       [&s](const Call& call) { return answer_job(s, call, visible_job(s, call)); }},
      {"DELETE", "/v1/jobs/{id}", Scope::Submit, with(delete_job)},
      {"GET", "/v1/jobs/{id}/events", {}, with(follow_events)},
      {"GET", "/v1/jobs/{id}/report", {}, with(send_report)},
      {"GET", "/v1/jobs/{id}/checks", {}, with(send_verdict)},
      {"POST", "/v1/jobs/{id}/cancel", Scope::Submit, with(cancel_job), kMostJson},
      {"POST", "/v1/jobs/{id}/requeue", Scope::Submit, with(requeue_job), kMostJson},
      {"POST", "/v1/jobs/{id}/review", Scope::Review, with(review_job), kMostJson},
      {"DELETE", "/v1/jobs/{id}/review", Scope::Review, with(take_back_review)},
      {"POST", "/v1/jobs/{id}/refit", Scope::Submit, with(submit_refit), kMostJson},
      {"GET", "/v1/jobs/{id}/{file...}", {}, [&s](const Call& call) {
         return send_file(s, call, {call.captured.begin() + 1, call.captured.end()});
       }}};
  Route submit{"POST", "/v1/jobs", Scope::Submit, {}};
  submit.upload = [&s](const Call& call) { return begin_job(s, call); };
  out.push_back(std::move(submit));
  return out;
}

}  // namespace regarment
