#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/speech.h"
#include "jobs/service_config.h"

namespace CLI {
class App;
}

namespace regarment {

/// Where the service is: what its commands have in common.
struct ServicePlace {
  std::optional<std::filesystem::path> config, data;
  std::optional<std::string> store, server;
};

/// regarment serve
struct ServeArguments {
  ServicePlace place;
  std::optional<std::string> bind;
  std::optional<int> port, workers;
};

/// regarment worker
struct WorkerArguments {
  Speech speech;
  ServicePlace place;
  std::optional<int> threads;
  bool until_empty = false;
};

/// regarment key ACTION [WHAT]
struct KeyArguments {
  Speech speech;
  ServicePlace place;
  std::string action;  // add, list or revoke
  std::string what;    // a name to add, an id to revoke
  std::vector<std::string> scopes;
};

/// regarment config check
struct ConfigArguments {
  Speech speech;
  ServicePlace place;
  std::string action;  // check
};

/// regarment doctor
struct DoctorArguments {
  Speech speech;
  ServicePlace place;
};

/// Declares --config, --data and --store.
void add_place_options(CLI::App& command, ServicePlace& place);
/// Declares --server, for commands that are of no use to the server itself.
void add_server_option(CLI::App& command, ServicePlace& place);

// Declare the options of a command.
void add_serve_options(CLI::App& command, ServeArguments& a);
void add_worker_options(CLI::App& command, WorkerArguments& a);
void add_key_options(CLI::App& command, KeyArguments& a);
void add_config_options(CLI::App& command, ConfigArguments& a);

/// What an action needs and may not have. Throws UsageError.
void check_key(const KeyArguments& a);

/// File, environment and then what the command line says of the place. Throws as
/// read_service_config does.
ReadConfig read_config_of(const ServicePlace& place);

}  // namespace regarment
