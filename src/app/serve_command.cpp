#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <thread>

#include "app/check_job_words.h"
#include "app/commands.h"
#include "base/error.h"
#include "http/server.h"
#include "jobs/sweep.h"
#include "service/job_service.h"
#include "service/notify.h"
#include "service/worker_processes.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

ServiceConfig config_of(const ServeArguments& a) {
  ServiceConfig config = read_config_of(a.place).config;
  if (a.bind) config.bind = *a.bind;
  if (a.port) config.port = *a.port;
  if (a.workers) config.workers = *a.workers;
  config.check();
  return config;
}

void check_bind(const ServiceConfig& config, Access& access) {
  if (config.bind == "127.0.0.1" || config.bind == "::1" || access.needs_key()) return;
  throw UsageError(
      "bind: " + config.bind +
      " can be reached by others and there is no API key; make one with 'regarment key "
      "add', or bind 127.0.0.1");
}

// As many connections as the system lets us have.
void raise_descriptor_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

ServerOptions server_options(const ServiceConfig& config) {
  ServerOptions out;
  out.address = config.bind;
  out.port = static_cast<std::uint16_t>(config.port);
  out.network_threads = config.http_threads;
  out.drain_time = std::chrono::seconds(static_cast<int>(config.drain_seconds));
  rlimit limit{};
  constexpr rlim_t kOwn = 128;  // descriptors for files, store and workers
  if (::getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur > 2 * kOwn)
    out.connections = std::min<std::size_t>(out.connections, (limit.rlim_cur - kOwn) / 2);
  return out;
}

// The store goes by the environment: its address may hold a password, and everybody sees words.
// Workers at the server's side share its folder, whatever a config for many machines says.
std::vector<std::string> worker_command(const ServeArguments& a, const ServiceConfig& config) {
  ::setenv("REGARMENT_STORE", config.store_or_default().c_str(), 1);
  ::setenv("REGARMENT_SERVER", "", 1);
  std::vector<std::string> out = {fs::read_symlink("/proc/self/exe").string(), "worker", "--data",
                                  fs::absolute(config.data).string()};
  if (a.place.config) out.insert(out.end(), {"--config", a.place.config->string()});
  return out;
}

// Removes jobs whose time is over, and what crashes left.
void sweep(const Service& service) {
  const auto keep = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::duration<double, std::ratio<3600>>(service.config.keep_hours));
  sweep_data(service.store, service.folders, keep, service.store.time());
}

// What is done beside the requests, on the main thread, until a signal comes.
void look_after(const Service& service, WorkerProcesses& workers, const StopSignal& stop) {
  constexpr std::chrono::milliseconds kLook{50};
  constexpr std::chrono::seconds kSweep{60};
  const auto watchdog = watchdog_interval();
  Clock::time_point next_sweep, feed;
  while (!stop.asked()) {
    const auto now = Clock::now();
    if (workers.look_after() > 0) std::cerr << log_line("warning", "worker_ended", {});
    if (watchdog && now >= feed) {
      notify_manager("WATCHDOG=1");
      feed = now + *watchdog;
    }
    if (now >= next_sweep) {
      try {
        sweep(service);
      } catch (const TemporaryError& error) {
        std::cerr << log_line("warning", "store_away", {{"error", error.what()}});
      }
      next_sweep = now + kSweep;
    }
    std::this_thread::sleep_for(kLook);
  }
}

std::string address_of(const ServiceConfig& config, std::uint16_t port) {
  const bool ipv6 = config.bind.find(':') != std::string::npos;
  return "http://" + (ipv6 ? "[" + config.bind + "]" : config.bind) + ":" + std::to_string(port);
}

}  // namespace

void run_serve(const ServeArguments& a, const StopSignal& stop) {
  const ServiceConfig config = config_of(a);
  // Workers hand their job back or end it; connections end; then nothing is left to wait for.
  const std::chrono::seconds patience(static_cast<int>(config.drain_seconds) + 3);
  stop.allow(patience + std::chrono::seconds(2));
  raise_descriptor_limit();
  const JobFolders folders(config.data);
  const std::unique_ptr<JobStore> store = open_job_store(config.store_or_default());
  const Service service{*store, folders, config, check_job_words};
  JobService handler(service, std::cerr);
  check_bind(config, handler.access());
  Server server(server_options(config), handler);
  WorkerProcesses workers(worker_command(a, config), config.workers);
  workers.look_after();
  Console::answer("listening on " + address_of(config, server.port()) + "\n");
  notify_manager("READY=1");
  look_after(service, workers, stop);
  notify_manager("STOPPING=1");
  workers.ask_to_end();
  server.stop();
  if (!workers.wait(patience)) std::cerr << log_line("warning", "workers_killed", {});
}

}  // namespace regarment
