#include <nlohmann/json.hpp>

#include "service/job_json.h"
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

Response show_batch(const Service& service, const Call& call) {
  const std::optional<Batch> batch = service.store.find_batch(call.captured.at(0));
  if (!batch || (!sees_all(call.caller) && batch->owner != call.caller.key.id))
    throw HttpProblem(404, "no_such_batch",
                      "there is no batch of this id; GET /v1/batches lists them");
  return text_response(200, kJson, batch_json(*batch));
}

}  // namespace

std::vector<Route> batch_routes(const Service& s) {
  std::vector<Route> out = {
      {"GET", "/v1/batches", {}, [&s](const Call& call) { return list_batches(s, call); }},
      {"POST", "/v1/batches", Scope::Submit, [&s](const Call& call) { return make_batch(s, call); },
       kMostJson},
      {"GET", "/v1/batches/{id}", {}, [&s](const Call& call) { return show_batch(s, call); }}};
  Route evaluate{"POST", "/v1/evaluations", Scope::Submit, {}};
  evaluate.upload = [&s](const Call& call) { return begin_evaluation(s, call); };
  out.push_back(std::move(evaluate));
  return out;
}

}  // namespace regarment
