#include "batch/batch_state.h"

#include <nlohmann/json.hpp>

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;
using State = ScanStatus::State;

void count(State state, BatchState& out) {
  if (state == State::Succeeded) ++out.succeeded;
  if (state == State::Failed) ++out.failed;
  if (state == State::Parked) ++out.parked;
}

Json scan_json(const std::string& name, const std::optional<ScanStatus>& status, int attempts) {
  Json out = {{"name", name}, {"state", status ? name_of(status->state) : "to be done"}};
  if (attempts > 0) out["attempts"] = attempts;
  if (status && status->failure) {
    out["error"] = {{"kind", status->failure->kind}, {"message", status->failure->line}};
  }
  return out;
}

}  // namespace

BatchState batch_state(const BatchFolder& folder, const Manifest& manifest) {
  BatchState out;
  out.merged = folder.is_merged();
  for (const BatchScan& scan : manifest.scans) {
    out.scans.push_back(folder.status(scan));
    out.attempts.push_back(folder.attempts(scan.name));
    if (out.scans.back()) count(out.scans.back()->state, out);
  }
  return out;
}

std::string state_line(const BatchState& state) {
  const bool unmerged = state.ended() == state.scans.size() && !state.merged;
  return std::to_string(state.ended()) + " of " + std::to_string(state.scans.size()) +
         " scans: " + std::to_string(state.succeeded) + " succeeded, " +
         std::to_string(state.failed) + " failed, " + std::to_string(state.parked) + " parked, " +
         std::to_string(state.scans.size() - state.ended()) + " to be done" +
         (unmerged ? "; not summed up yet: if nothing works on it, run 'regarment batch' again"
                   : "");
}

std::string state_text(const Manifest& manifest, const BatchState& state) {
  std::string out = state_line(state) + "\n";
  for (std::size_t i = 0; i < state.scans.size(); ++i) {
    const std::string& name = manifest.scans[i].name;
    const auto& status = state.scans[i];
    if (status && status->failure) {
      out += name_of(status->state) + "  " + name + ": " + status->failure->line + "\n";
    } else if (!status && state.attempts[i] > 0) {
      out += "begun " + std::to_string(state.attempts[i]) + " times and not ended  " + name + "\n";
    }
  }
  return out;
}

std::string state_json(const Manifest& manifest, const BatchState& state) {
  Json scans = Json::array();
  for (std::size_t i = 0; i < state.scans.size(); ++i) {
    scans.push_back(scan_json(manifest.scans[i].name, state.scans[i], state.attempts[i]));
  }
  const Json json = {{"scans", state.scans.size()},
                     {"succeeded", state.succeeded},
                     {"failed", state.failed},
                     {"parked", state.parked},
                     {"to_be_done", state.scans.size() - state.ended()},
                     {"merged", state.merged},
                     {"status", scans}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace regarment
