#include "batch/scan_status.h"

#include <array>
#include <nlohmann/json.hpp>

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;
using State = ScanStatus::State;

constexpr std::array kStates = {State::Succeeded, State::Failed, State::Parked};

ScanStatus parse(const Json& json) {
  ScanStatus out;
  const auto state = json.at("state").get<std::string>();
  for (const State one : kStates) {
    if (name_of(one) == state) out.state = one;
  }
  if (name_of(out.state) != state) json.at("no such state");
  out.name = json.at("name").get<std::string>();
  out.key = json.at("key").get<std::string>();
  if (out.state == State::Succeeded) {
    out.result_sha256 = json.at("result_sha256").get<std::string>();
    return out;
  }
  const Json& error = json.at("error");
  out.failure = {error.at("kind").get<std::string>(), error.at("status").get<int>(),
                 error.at("message").get<std::string>()};
  return out;
}

}  // namespace

std::string name_of(State state) {
  if (state == State::Succeeded) return "succeeded";
  return state == State::Failed ? "failed" : "parked";
}

std::string status_json(const ScanStatus& status) {
  Json json = {{"name", status.name}, {"state", name_of(status.state)}, {"key", status.key}};
  if (status.failure) {
    json["error"] = {{"kind", status.failure->kind},
                     {"status", status.failure->status},
                     {"message", status.failure->line}};
  } else {
    json["result_sha256"] = status.result_sha256;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<ScanStatus> parse_status(const std::string& text) {
  try {
    return parse(Json::parse(text));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace regarment
