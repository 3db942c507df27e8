// The commands beside `serve`: worker, key, config.

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/error.h"
#include "base/one_line.h"
#include "jobs/server_files.h"
#include "jobs/worker.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

// The store and its folder; the folder is made only where the store lies in it.
std::unique_ptr<JobStore> open_store(const ServiceConfig& config) {
  if (config.store.empty()) JobFolders folders(config.data);
  return open_job_store(config.store_or_default());
}

Json key_json(const ApiKey& key) {
  Json scopes = Json::array();
  for (const Scope scope : key.scopes) scopes.push_back(name_of(scope));
  Json json = {
      {"id", key.id}, {"name", key.name}, {"scopes", scopes}, {"created", rfc3339(key.created)}};
  if (key.revoked) json["revoked"] = rfc3339(*key.revoked);
  return json;
}

std::string key_line(const ApiKey& key) {
  std::string scopes;
  for (const Scope scope : key.scopes) {
    scopes.append(scopes.empty() ? "" : ",").append(name_of(scope));
  }
  return key.id + "  " + rfc3339(key.created) + "  " + scopes + "  " + one_line(key.name, 100) +
         (key.revoked ? "  (revoked " + rfc3339(*key.revoked) + ")" : "");
}

void add_key(const KeyArguments& a, JobStore& store, Console& console) {
  std::vector<Scope> scopes;
  for (const std::string& name : a.scopes) {
    const Scope scope = *scope_named(name);
    if (std::find(scopes.begin(), scopes.end(), scope) == scopes.end()) scopes.push_back(scope);
  }
  const std::string secret = issue_key(store, a.what, scopes);
  if (console.wants_json()) {
    console.answer(Json{{"key", secret}}.dump() + "\n");
  } else {
    // Whoever asks for a key wants it, --quiet or not.
    console.answer(secret + "\n");
  }
}

void list_keys(JobStore& store, Console& console) {
  if (console.wants_json()) {
    Json list = Json::array();
    for (const ApiKey& key : store.keys()) list.push_back(key_json(key));
    console.answer(list.dump(2) + "\n");
    return;
  }
  for (const ApiKey& key : store.keys()) console.answer(key_line(key) + "\n");
}

std::unique_ptr<JobFiles> files_of(const ServiceConfig& config, Console& console) {
  if (config.server.empty()) return std::make_unique<SharedFiles>(JobFolders(config.data));
  if (config.store.empty())
    throw UsageError(
        "--server: name the job store as well, with --store or REGARMENT_STORE; the server's own "
        "lies where only it reaches");
  FileServer server = file_server(config);
  if (!server.address.tls && !server.address.is_loopback())
    console.complain("warning: " + server.address.text() +
                     " is not encrypted: others on the network can read scans and the key; give an "
                     "https address, or use a network of your own");
  return std::make_unique<ServerFiles>(std::move(server), config.data);
}

}  // namespace

void run_worker_command(const WorkerArguments& a, Console& console, const StopSignal& stop) {
  const ServiceConfig config = read_config_of(a.place).config;
  const auto files = files_of(config, console);
  const auto store = open_job_store(config.store_or_default());
  // No fit needs to know these.
  ::unsetenv("REGARMENT_STORE");
  ::unsetenv("REGARMENT_SERVER_KEY");
  WorkerOptions options = WorkerOptions::from(config);
  options.program = std::filesystem::read_symlink("/proc/self/exe");
  if (a.threads) options.threads = *a.threads;
  options.until_empty = a.until_empty;
  // Asked to stop, it hands its job back; only then is it too late.
  stop.allow(options.grace + std::chrono::seconds(5));
  const auto wanted = [&] { return !stop.asked(); };
  files->check(wanted);
  console.say("worker ready");
  run_worker(*store, *files, options, wanted);
}

void run_key(const KeyArguments& a, Console& console) {
  const auto store = open_store(read_config_of(a.place).config);
  if (a.action == "add") return add_key(a, *store, console);
  if (a.action == "list") return list_keys(*store, console);
  if (!store->revoke_key(a.what)) {
    throw UsageError("key revoke: no key has the id '" + one_line(a.what, 60) +
                     "', or it is revoked already; 'key list' shows them");
  }
  console.say("revoked");
}

void run_config(const ConfigArguments& a, Console& console) {
  const ReadConfig read = read_config_of(a.place);
  if (console.wants_json()) {
    Json json = Json::object();
    for (const ConfigEntry& entry : read.entries) {
      json[entry.name] = {{"value", entry.value}, {"from", entry.from}};
    }
    console.answer(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    return;
  }
  for (const ConfigEntry& entry : read.entries) {
    std::string name = entry.name;
    name.resize(18, ' ');
    console.say(name + one_line(entry.value, 300) + "  (" + entry.from + ")");
  }
}

}  // namespace regarment
