// What the service stands on, looked at one by one.

#include <functional>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/error.h"
#include "base/one_line.h"
#include "garment/find_template.h"
#include "jobs/server_files.h"
#include "jobs/worker.h"
#include "render/context.h"
#include "report/version.h"
#include "scan/sandbox.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

/// A part and how it is, found or thrown: what an Error says is what to do.
struct Part {
  std::string name;
  bool ok = true;
  std::string line;
};

Part look_at(const std::string& name, const std::function<std::string()>& look) {
  try {
    return {name, true, look()};
  } catch (const std::exception& error) {
    return {name, false, one_line(error.what(), 500)};
  }
}

std::string templates() {
  const auto entries = list_templates();
  for (const TemplateEntry& entry : entries) find_template(entry.name);
  return std::to_string(entries.size()) + " garment templates";
}

std::string sandbox() {
  if (sandbox_is_closed()) return "scans are read in a closed child process";
  throw TemporaryError("a build with sanitizers reads scans unprotected; use a release build");
}

std::string disk(const ServiceConfig& config) {
  const JobFolders folders(config.data);
  const std::uint64_t free_mb = folders.free_bytes() >> 20U;
  if (free_mb < config.min_free_mb) {
    throw TemporaryError(folders.data().string() + ": " + std::to_string(free_mb) +
                         " MiB are free, fewer than min_free_mb (" +
                         std::to_string(config.min_free_mb) + "); delete old jobs, or allow less");
  }
  return one_line(folders.data().string(), 300) + ", " + std::to_string(free_mb) + " MiB free";
}

std::string store(const ServiceConfig& config) {
  const auto store = open_job_store(config.store_or_default());
  store->check_writable();
  std::string line = shown_store(config.store_or_default()) + ", schema " +
                     std::to_string(store->schema_version());
  const QueueFacts facts = store->facts();
  for (const JobState state : kJobStates) {
    const auto count = facts.jobs[static_cast<std::size_t>(state)];
    if (count > 0) line += ", " + std::to_string(count) + " " + std::string(name_of(state));
  }
  return line;
}

std::string workers(const ServiceConfig& config) {
  const auto store = open_job_store(config.store_or_default());
  const auto patience =
      std::chrono::milliseconds(static_cast<std::int64_t>(1000 * config.lease_seconds));
  const auto alive = store->workers(store->time() - patience).size();
  const auto waiting = store->facts().jobs[static_cast<std::size_t>(JobState::Queued)];
  if (alive == 0 && waiting > 0) {
    throw TemporaryError(std::to_string(waiting) +
                         " jobs wait and no worker lives; start 'regarment serve' or "
                         "'regarment worker'");
  }
  if (alive == 0) return "none lives, none is needed";
  return std::to_string(alive) + (alive == 1 ? " lives" : " live");
}

std::string server(const ServiceConfig& config) {
  const FileServer server = file_server(config);
  HttpClient client(server.address, server.client);
  const std::string there = server_version(client, [] { return true; });
  return server.address.text() + " takes the key, version " + there +
         (there == version() ? "" : " (this is " + version() + ")");
}

std::vector<Part> look_at_all(const ServicePlace& place) {
  ServiceConfig config;
  std::vector<Part> parts;
  parts.push_back(look_at("program", [] { return "regarment " + version(); }));
  parts.push_back(look_at("config", [&]() -> std::string {
    config = read_config_of(place).config;
    return "good";
  }));
  parts.push_back(look_at("drawing", [] { return Context::of_this_thread().description(); }));
  parts.push_back(look_at("templates", templates));
  parts.push_back(look_at("sandbox", sandbox));
  parts.push_back(look_at("disk", [&] { return disk(config); }));
  parts.push_back(look_at("store", [&] { return store(config); }));
  parts.push_back(look_at("workers", [&] { return workers(config); }));
  if (!config.server.empty()) parts.push_back(look_at("server", [&] { return server(config); }));
  return parts;
}

}  // namespace

void run_doctor(const DoctorArguments& a, Console& console) {
  const std::vector<Part> parts = look_at_all(a.place);
  std::size_t failed = 0;
  Json json = Json::array();
  for (const Part& part : parts) {
    failed += part.ok ? 0 : 1;
    json.push_back({{"part", part.name}, {"ok", part.ok}, {"says", part.line}});
    std::string name = part.name;
    name.resize(11, ' ');
    console.say((part.ok ? "ok      " : "failed  ") + name + part.line);
  }
  if (console.wants_json()) {
    console.answer(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  }
  if (failed > 0) {
    throw GateError(std::to_string(failed) + " of " + std::to_string(parts.size()) +
                    " parts failed; do what their lines say");
  }
}

}  // namespace regarment
