#include <nlohmann/json.hpp>

#include "service/job_json.h"
#include "service/result_files.h"
#include "service/routes.h"
#include "service/submit.h"

namespace regarment {
namespace {

constexpr std::uint64_t kMostJson = 64U << 10U;
constexpr std::size_t kLongestName = 255;
constexpr int kMostBatches = 500;
constexpr const char* kJson = "application/json";

bool sees_all(const Caller& caller) { return caller.may(Scope::Read) || caller.may(Scope::Review); }

Response make_batch(const Service& service, const Call& call) {
  const nlohmann::json body = nlohmann::json::parse(call.body, nullptr, false);
  if (!body.is_object() || !body.contains("name") || !body["name"].is_string())
    throw HttpProblem(400, "bad_json", "the body must be {\"name\": TEXT}");
  const auto name = body["name"].get<std::string>();
  if (name.empty() || name.size() > kLongestName)
    throw HttpProblem(422, "bad_name", "name: give 1 to 255 bytes");
  const Batch batch = service.store.create_batch(name, call.caller.key.id);
  Response out = text_response(201, kJson, batch_json(batch));
  out.headers.add("Location", "/v1/batches/" + batch.id);
  return out;
}

Response list_batches(const Service& service, const Call& call) {
  const std::string owner = sees_all(call.caller) ? "" : call.caller.key.id;
  return text_response(200, kJson, batches_json(service.store.batches(owner, kMostBatches)));
}

Batch visible_batch(const Service& service, const Call& call) {
  const std::optional<Batch> batch = service.store.find_batch(call.captured.at(0));
  if (!batch || (!sees_all(call.caller) && batch->owner != call.caller.key.id))
    throw HttpProblem(404, "no_such_batch",
                      "there is no batch of this id; GET /v1/batches lists them");
  return *batch;
}

Response show_batch(const Service& service, const Call& call) {
  return text_response(200, kJson, batch_json(visible_batch(service, call)));
}

// The page of the newest evaluation.
Response send_evaluation(const Service& service, const Call& call) {
  const JobPage page = service.store.list({.states = {JobState::Succeeded},
                                           .batch = visible_batch(service, call).id,
                                           .kind = JobKind::Evaluate,
                                           .limit = 1});
  if (page.jobs.empty())
    throw HttpProblem(404, "no_evaluation",
                      "the batch was not evaluated yet; POST to this address does that");
  Response out =
      result_file(call.request, service.folders.result(page.jobs.front()), {"evaluation.html"});
  out.headers.add("Content-Location", "/v1/jobs/" + page.jobs.front().id + "/report");
  return out;
}

std::unique_ptr<Exchange> evaluate_batch(const Service& service, const Call& call) {
  const Batch batch = visible_batch(service, call);
  if (batch.owner != call.caller.key.id && !call.caller.may(Scope::Admin))
    throw HttpProblem(403, "not_yours", "this key may not add jobs to this batch");
  return begin_batch_evaluation(service, call, batch);
}

}  // namespace

std::vector<Route> batch_routes(const Service& s) {
  std::vector<Route> out = {
      {"GET", "/v1/batches", {}, [&s](const Call& call) { return list_batches(s, call); }},
      {"POST", "/v1/batches", Scope::Submit, [&s](const Call& call) { return make_batch(s, call); },
       kMostJson},
      {"GET", "/v1/batches/{id}", {}, [&s](const Call& call) { return show_batch(s, call); }},
      {"GET", "/v1/batches/{id}/evaluation", {}, [&s](const Call& call) {
         return send_evaluation(s, call);
       }}};
  Route of_batch{"POST", "/v1/batches/{id}/evaluation", Scope::Submit, {}};
  of_batch.upload = [&s](const Call& call) { return evaluate_batch(s, call); };
  out.push_back(std::move(of_batch));
  Route evaluate{"POST", "/v1/evaluations", Scope::Submit, {}};
  evaluate.upload = [&s](const Call& call) { return begin_evaluation(s, call); };
  out.push_back(std::move(evaluate));
  return out;
}

}  // namespace regarment
