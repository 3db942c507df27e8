#include "app/service_options.h"

#include <CLI/CLI.hpp>

#include "app/one_each.h"
#include "base/error.h"
#include "base/one_line.h"
#include "jobs/api_key.h"
#include "jobs/job_store.h"

namespace regarment {

void add_place_options(CLI::App& command, ServicePlace& place) {
  command.add_option("--config", place.config,
                     "Config file (TOML); REGARMENT_... in the environment counts more, options "
                     "here most");
  command.add_option("--data", place.data,
                     "Folder of uploads, results and the store; regarment-data by default");
  command.add_option("--store", place.store,
                     "Job store: an SQLite file, or postgresql://USER@HOST/NAME for many machines; "
                     "store.sqlite3 in the folder by default");
}

void add_server_option(CLI::App& command, ServicePlace& place) {
  command.add_option(
      "--server", place.server,
      "Server that has the files of the jobs, http://HOST:PORT or https://HOST, where "
      "--data is not shared with it; its key is REGARMENT_SERVER_KEY");
}

void add_serve_options(CLI::App& command, ServeArguments& a) {
  add_place_options(command, a.place);
  command.add_option("--port", a.port, "Port; 0 for any that is free")->check(CLI::Range(0, 65535));
  command.add_option("--bind", a.bind, "Address; any but 127.0.0.1 and ::1 needs an API key");
  command.add_option("--workers", a.workers, "Worker processes; 0 for none")
      ->check(CLI::Range(0, 256));
}

void add_worker_options(CLI::App& command, WorkerArguments& a) {
  add_place_options(command, a.place);
  add_server_option(command, a.place);
  command.add_option("--threads", a.threads, "Threads of each fit")->check(CLI::Range(1, 256));
  command.add_flag("--until-empty", a.until_empty, "End once no job waits");
}

void add_key_options(CLI::App& command, KeyArguments& a) {
  command.add_option("ACTION", a.action, "add NAME, list, or revoke ID")
      ->required()
      ->check(CLI::IsMember({"add", "list", "revoke"}));
  command.add_option("WHAT", a.what, "Name of the key to add, or id of the one to revoke");
  std::vector<std::string> scopes;
  scopes.reserve(kScopes.size());
  for (const Scope scope : kScopes) scopes.emplace_back(name_of(scope));
  one_each(command.add_option(
               "--scope", a.scopes,
               "What the key may do: submit, read, review, work or admin; repeat for more"))
      ->check(CLI::IsMember(scopes));
  add_place_options(command, a.place);
}

void add_config_options(CLI::App& command, ConfigArguments& a) {
  command.add_option("ACTION", a.action, "check: read it and show every field")
      ->required()
      ->check(CLI::IsMember({"check"}));
  add_place_options(command, a.place);
}

void check_key(const KeyArguments& a) {
  if (a.action == "add" && (a.what.empty() || a.scopes.empty())) {
    throw UsageError(
        "key add: give a name and what it may do, as in 'key add scanner --scope "
        "submit --scope read'");
  }
  if (a.action == "revoke" && a.what.empty()) {
    throw UsageError("key revoke: give the id of a key; 'key list' shows them");
  }
  if (a.action == "list" && !a.what.empty()) {
    throw UsageError("key list: '" + one_line(a.what, 60) + "' is one argument too many");
  }
  if (a.action != "add" && !a.scopes.empty()) {
    throw UsageError("key " + a.action + ": --scope is for 'key add'");
  }
}

ReadConfig read_config_of(const ServicePlace& place) {
  ReadConfig read = read_service_config(place.config);
  const auto said = [&](const std::string& name, const std::string& value) {
    for (ConfigEntry& entry : read.entries) {
      if (entry.name == name) entry.value = value, entry.from = "command line";
    }
  };
  if (place.data) read.config.data = *place.data, said("data", place.data->string());
  if (place.store) read.config.store = *place.store, said("store", shown_store(*place.store));
  if (place.server) read.config.server = *place.server, said("server", *place.server);
  read.config.check();
  return read;
}

}  // namespace regarment
