#include <algorithm>
#include <nlohmann/json.hpp>

#include "jobs/job_inputs.h"
#include "report/files.h"
#include "report/version.h"
#include "service/delivery.h"
#include "service/result_files.h"
#include "service/routes.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMostList = std::uint64_t{16} << 20U;
constexpr const char* kJson = "application/json";

Response tell_version() {
  return text_response(200, kJson, Json{{"version", version()}}.dump() + "\n");
}

// What another attempt left goes, as it does before a worker with the folder at hand begins.
Response start_work(const Service& service, const Call& call) {
  const Job job = held_job(service, call);
  service.folders.remove_leftovers(job.id, -1);
  prepare_inputs(job, service.folders, service.store);
  Json files = Json::array();
  for (const std::string& name : job_inputs(job, service.folders, service.store)) {
    const fs::path file = service.folders.data() / "jobs" / name;
    std::error_code gone;
    const std::uint64_t bytes = fs::file_size(file, gone);
    if (!gone) files.push_back({{"name", name}, {"bytes", bytes}, {"sha256", file_sha256(file)}});
  }
  return text_response(
      200, kJson,
      Json{{"files", files}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Response send_input(const Service& service, const Call& call) {
  const Job job = held_job(service, call);
  const std::vector<std::string> path(call.captured.begin() + 1, call.captured.end());
  std::string name;
  for (const std::string& part : path) name += (name.empty() ? "" : "/") + part;
  const std::vector<std::string> inputs = job_inputs(job, service.folders, service.store);
  if (!std::binary_search(inputs.begin(), inputs.end(), name))
    throw HttpProblem(404, "no_such_file", "the job reads no such file; begin again with 'start'");
  return result_file(call.request, service.folders.data() / "jobs", path);
}

}  // namespace

std::vector<Route> work_routes(const Service& s) {
  Route file{"PUT", "/v1/work/{id}/result/{file...}", Scope::Work, {}};
  file.upload = [&s](const Call& call) { return begin_delivery(s, call); };
  return {{"GET", "/v1/work", Scope::Work, [](const Call&) { return tell_version(); }},
          {"POST", "/v1/work/{id}/start", Scope::Work,
           [&s](const Call& call) { return start_work(s, call); }},
          {"GET", "/v1/work/{id}/files/{file...}", Scope::Work,
           [&s](const Call& call) { return send_input(s, call); }},
          {"POST", "/v1/work/{id}/result", Scope::Work,
           [&s](const Call& call) { return commit_delivery(s, call); }, kMostList},
          std::move(file)};
}

}  // namespace regarment
