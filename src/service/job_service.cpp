#include "service/job_service.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "report/text.h"
#include "service/routes.h"

namespace regarment {
namespace {

constexpr const char* kNoRoute = "-";

void check_scope(const Route& route, const Caller& caller) {
  if (!route.need || caller.may(*route.need)) return;
  throw HttpProblem(403, "no_scope",
                    "this key does not have the scope '" + std::string(name_of(*route.need)) + "'");
}

// Methods come from outside; those nobody knows are all one.
std::string known_method(const std::string& method) {
  for (const char* known : {"GET", "HEAD", "POST", "PUT", "DELETE", "PATCH", "OPTIONS"})
    if (method == known) return method;
  return "OTHER";
}

}  // namespace

std::string log_line(std::string_view level, std::string_view event,
                     const std::vector<std::pair<std::string, std::string>>& facts) {
  nlohmann::ordered_json line = {
      {"time", rfc3339(system_time())}, {"level", level}, {"event", event}};
  for (const auto& [name, value] : facts) line[name] = value;
  return line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

JobService::JobService(const Service& service, std::ostream& log)
    : access_(service.store), log_(log) {
  for (auto& routes : {fact_routes(service, metrics_), job_routes(service), batch_routes(service),
                       work_routes(service), session_routes(access_), page_routes()})
    add(routes);
}

void JobService::add(std::vector<Route> routes) {
  for (Route& route : routes) routes_.push_back(std::move(route));
}

std::optional<Response> JobService::at_once(const Request& request) {
  static const std::vector<std::string> kHealth = {"healthz"};
  if (request.path != kHealth || request.method != "GET") return std::nullopt;
  return text_response(200, "text/plain", "ok\n");
}

std::unique_ptr<Exchange> JobService::begin(const Request& request) {
  const FoundRoute found = find_route(routes_, request);
  if (!found.route || !found.route->open) {
    // Who may not ask is not told what there is.
    Caller caller = access_.admit(request);
    if (found.route) {
      check_scope(*found.route, caller);
      Call call{request, std::move(caller), found.captured, {}};
      if (found.route->upload) return found.route->upload(call);
      return gathered(*found.route, std::move(call));
    }
  }
  if (!found.route && !found.allowed.empty())
    throw HttpProblem(405, "no_such_method", "this address does not take this method",
                      {{"Allow", found.allowed}});
  if (!found.route)
    throw HttpProblem(404, "no_such_address",
                      "there is nothing here; GET /openapi.json says what "
                      "there is");
  return gathered(*found.route, {request, {}, found.captured, {}});
}

void JobService::served(const Request* request, const Served& served) {
  constexpr double kMilliseconds = 1000;
  std::string route = kNoRoute, method = kNoRoute, id;
  if (request != nullptr) {
    const FoundRoute found = find_route(routes_, *request);
    if (found.route) route = found.route->pattern;
    method = known_method(request->method);
    id = request->id;
  }
  metrics_.count(method, route, served);
  if (route == "/healthz") return;
  std::vector<std::pair<std::string, std::string>> facts = {
      {"request_id", id},
      {"method", method},
      {"route", route},
      {"status", std::to_string(served.status)},
      {"ms", fixed_text(served.seconds * kMilliseconds, 1)},
      {"bytes_in", std::to_string(served.bytes_in)},
      {"bytes_out", std::to_string(served.bytes_out)}};
  if (!served.internal_error.empty()) facts.emplace_back("error", served.internal_error);
  const std::string line =
      log_line(served.internal_error.empty() ? "info" : "error", "request", facts);
  const std::lock_guard lock(log_mutex_);
  log_ << line << std::flush;
}

}  // namespace regarment
