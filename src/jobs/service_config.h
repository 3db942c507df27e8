#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace regarment {

/// Everything `serve` and `worker` can be told. In the file (TOML) each field has the name it has
/// here; in the environment REGARMENT_ and the name in capitals. What counts, most first: command
/// line, environment, file, these defaults.
struct ServiceConfig {
  std::filesystem::path data = "regarment-data";  // folder of all files
  std::string store;                     // job store (job_store.h); empty: SQLite in `data`
  std::string server;                    // of a worker: http(s)://HOST:PORT of the server that has
                                         // the files; empty: it shares `data` with the server
  std::string server_key;                // API key for it, of the scope "work"; empty: none
  std::string bind = "127.0.0.1";        // address; any other than a loopback one needs an API key
  int port = 8080;                       // 0: any that is free
  int http_threads = 2;                  // of the server, 1 to 64
  int workers = 1;                       // processes `serve` starts; 0: none
  int threads = 1;                       // of each fit, 1 to 256
  std::uint64_t max_upload_mb = 512;     // of one request
  std::uint64_t max_queue = 1000;        // jobs waiting; more are refused with 429
  std::uint64_t max_jobs_per_key = 200;  // not ended; more are refused with 429
  std::uint64_t quota_mb = 0;            // of all jobs of one key; 0: no limit
  std::uint64_t min_free_mb = 512;       // free disk below which nothing is accepted (507)
  double keep_hours = 0;                 // ended jobs are deleted after this; 0: kept
  double lease_seconds = 30;             // a worker silent for so long has lost its job
  int max_attempts = 3;                  // crashes before a job is parked as dead
  std::uint64_t fit_memory_mb = 4096;    // address space of one fit; 0: no limit
  double fit_seconds = 1800;             // wall time of one fit
  std::uint64_t fit_file_mb = 2048;      // of any one file a fit writes; 0: no limit
  double drain_seconds = 10;             // SIGTERM: how long running work may still take

  /// Throws UsageError that names the field, its value and what it may be.
  void check() const;
  /// `store`, or the SQLite file in `data`.
  std::string store_or_default() const;
};

/// One field of the config as text, fit to be shown, and who set it: "default", "file",
/// "environment".
struct ConfigEntry {
  std::string name, value, from;
};

struct ReadConfig {
  ServiceConfig config;
  std::vector<ConfigEntry> entries;  // in the order of the fields
};

/// Value of an environment variable, or nothing.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// The process's own environment.
std::optional<std::string> process_environment(const std::string& name);

/// Reads the file where one is given, then the environment, and checks. A REGARMENT_ variable that
/// is no field is left to others. Throws UsageError (unknown field with the nearest known one,
/// wrong type, value out of range, with the line of the file) and ReadError (no such file).
ReadConfig read_service_config(const std::optional<std::filesystem::path>& file,
                               const Environment& environment = process_environment);

}  // namespace regarment
