#include "jobs/worker.h"

#include <unistd.h>

#include <array>
#include <thread>

#include "base/error.h"
#include "base/one_line.h"
#include "jobs/attempt.h"

namespace regarment {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kStoreRetry{500};

std::chrono::milliseconds from_seconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000 * seconds));
}

std::string machine_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "localhost";
  return one_line(name.data(), 100);
}

// The process alone would not do: numbers come again.
std::string worker_name(const std::string& host) {
  return host + "/" + std::to_string(::getpid()) + "-" + random_hex(3);
}

/// Says now and then that the worker lives.
class Pulse {
 public:
  Pulse(JobStore& store, std::string id, std::string host, std::chrono::milliseconds every)
      : store_(store), id_(std::move(id)), host_(std::move(host)), every_(every) {}
  ~Pulse() {
    try {
      store_.worker_gone(id_);
    } catch (const Error&) {
      // It is known for a while as one that fell silent.
    }
  }
  Pulse(const Pulse&) = delete;
  Pulse& operator=(const Pulse&) = delete;

  const std::string& id() const { return id_; }
  void beat() {
    const auto now = Clock::now();
    if (last_ && now < *last_ + every_) return;
    store_.worker_alive(id_, host_);
    last_ = now;
  }

 private:
  JobStore& store_;
  std::string id_, host_;
  std::chrono::milliseconds every_;
  std::optional<Clock::time_point> last_;
};

bool nothing_waits(JobStore& store) { return store.queued_jobs(1) == 0; }

}  // namespace

WorkerOptions WorkerOptions::from(const ServiceConfig& config) {
  WorkerOptions out;
  out.threads = config.threads;
  out.lease = from_seconds(config.lease_seconds);
  out.max_attempts = config.max_attempts;
  out.memory_mb = config.fit_memory_mb;
  out.file_mb = config.fit_file_mb;
  out.time = from_seconds(config.fit_seconds);
  out.grace = from_seconds(config.drain_seconds);
  return out;
}

void run_worker(JobStore& store, JobFiles& files, const WorkerOptions& given,
                const std::function<bool()>& wanted) {
  WorkerOptions options = given;
  if (options.host.empty()) options.host = machine_name();
  if (::access(options.program.c_str(), X_OK) != 0) {
    throw UsageError(one_line(options.program.string(), 300) +
                     ": cannot be run; name the regarment program");
  }
  Pulse pulse(store, worker_name(options.host), options.host, options.lease / 4);
  while (wanted()) {
    try {
      pulse.beat();
      files.check(wanted);
      if (const auto claim = store.claim(pulse.id(), options.lease, options.max_attempts)) {
        run_attempt(*claim, store, files, options, wanted);
        continue;
      }
      if (options.until_empty && nothing_waits(store)) return;
      std::this_thread::sleep_for(options.poll);
    } catch (const Stopped&) {
      return;
    } catch (const TemporaryError&) {
      std::this_thread::sleep_for(kStoreRetry);
    }
  }
}

}  // namespace regarment
