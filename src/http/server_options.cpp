#include "base/error.h"
#include "http/server.h"

namespace regarment {
namespace {

void check_range(const char* name, std::int64_t value, std::int64_t least, std::int64_t most) {
  if (value < least || value > most)
    throw UsageError(std::string(name) + ": " + std::to_string(value) + " is not between " +
                     std::to_string(least) + " and " + std::to_string(most));
}

}  // namespace

void ServerOptions::check() const {
  constexpr std::int64_t kDay = 86400;
  check_range("network_threads", network_threads, 1, 64);
  check_range("handler_threads", handler_threads, 1, 256);
  check_range("header_bytes", static_cast<std::int64_t>(header_bytes), 1024, 65536);
  check_range("connections", static_cast<std::int64_t>(connections), 1, 1'000'000);
  check_range("event_streams", static_cast<std::int64_t>(event_streams), 0, 1'000'000);
  check_range("header_time", header_time.count(), 1, kDay);
  check_range("idle_time", idle_time.count(), 1, kDay);
  check_range("body_time", body_time.count(), 1, kDay);
  check_range("drain_time", drain_time.count(), 0, kDay);
  check_range("event_poll", event_poll.count(), 10, 60'000);
}

}  // namespace regarment
