#include <nlohmann/json.hpp>

#include "garment/find_template.h"
#include "report/embedded.h"
#include "report/template_json.h"
#include "report/version.h"
#include "service/routes.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMega = 1'000'000;
constexpr const char* kJson = "application/json";

Response fresh_or_same(const Call& call, const std::string& json) {
  Response out = text_response(200, kJson, json);
  out.headers.add("Cache-Control", "private, no-cache");
  return with_etag(call.request, std::move(out));
}

Response show_template(const Call& call) {
  const std::string& name = call.captured.at(0);
  for (const TemplateEntry& entry : list_templates())
    if (entry.name == name) return fresh_or_same(call, template_json(find_template(name)));
  throw HttpProblem(404, "no_such_template",
                    "there is no template of this name; GET /v1/templates lists them");
}

Json check_of(const char* name, bool good, const std::string& detail) {
  return {{"name", name}, {"ok", good}, {"detail", detail}};
}

Json check_store(const Service& service) try {
  service.store.check_writable();
  return check_of("store", true, "can be written");
} catch (const Error&) {
  return check_of("store", false, "cannot be written now");
}

Json check_workers(const Service& service) try {
  const auto lease = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::duration<double>(service.config.lease_seconds));
  const std::size_t count = service.store.workers(service.store.time() - lease).size();
  return check_of("workers", count > 0, std::to_string(count) + " heard of");
} catch (const Error&) {
  return check_of("workers", false, "not known");
}

Response tell_readiness(const Service& service) {
  const bool room = service.folders.free_bytes() >= service.config.min_free_mb * kMega;
  const Json checks = {check_store(service), check_workers(service),
                       check_of("disk", room, room ? "has room" : "is nearly full"),
                       check_of("templates", !list_templates().empty(), "are there")};
  bool ready = true;
  for (const Json& check : checks) ready = ready && check["ok"].get<bool>();
  return text_response(ready ? 200 : 503, kJson,
                       Json{{"ready", ready}, {"checks", checks}}.dump(2) + "\n");
}

}  // namespace

std::vector<Route> fact_routes(const Service& s, const Metrics& metrics) {
  std::vector<Route> open = {
      {"GET", "/healthz", {}, [](const Call&) { return text_response(200, "text/plain", "ok\n"); }},
      {"GET", "/readyz", {}, [&s](const Call&) { return tell_readiness(s); }},
      {"GET",
       "/version",
       {},
       [](const Call&) {
         return text_response(200, kJson, Json{{"version", version()}}.dump() + "\n");
       }},
      {"GET", "/openapi.json", {}, [](const Call& call) {
         return fresh_or_same(call, embedded_text("openapi.json"));
       }}};
  for (Route& route : open) route.open = true;
  open.push_back({"GET", "/metrics", Scope::Read, [&s, &metrics](const Call&) {
                    return text_response(200, "text/plain; version=0.0.4; charset=utf-8",
                                         metrics.text(s));
                  }});
  open.push_back({"GET", "/v1/templates", {}, [](const Call& call) {
                    return fresh_or_same(call, templates_json());
                  }});
  open.push_back({"GET", "/v1/templates/{name}", {}, show_template});
  return open;
}

std::vector<Route> session_routes(Access& access) {
  constexpr std::uint64_t kMostJson = 4096;
  Route begin{"POST", "/v1/session", {}, [&access](const Call& call) {
                const auto body = nlohmann::json::parse(call.body, nullptr, false);
                if (!body.is_object() || !body.contains("key") || !body["key"].is_string())
                  throw HttpProblem(400, "bad_json", "the body must be {\"key\": TEXT}");
                Response out = text_response(204, "", "");
                out.headers.add("Set-Cookie", access.begin_session(body["key"]));
                return out;
              }};
  begin.body_limit = kMostJson;
  begin.open = true;
  Route end{"DELETE", "/v1/session", {}, [&access](const Call& call) {
              Response out = text_response(204, "", "");
              out.headers.add("Set-Cookie", access.end_session(call.request));
              return out;
            }};
  return {begin, end};
}

}  // namespace regarment
