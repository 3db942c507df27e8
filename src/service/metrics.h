#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

#include "http/server.h"
#include "service/service.h"

namespace regarment {

/// Counters of requests, written as Prometheus reads them. Any thread.
class Metrics {
 public:
  /// `route` is a pattern of ours, never what a client wrote.
  void count(const std::string& method, const std::string& route, const Served& served);

  /// The text of /metrics: requests, their times, bytes, and how the queue stands.
  std::string text(const Service& service) const;

 private:
  static constexpr std::array kBounds = {0.001, 0.005, 0.02, 0.1, 0.5, 2.0, 10.0};  // s

  mutable std::mutex mutex_;
  std::map<std::tuple<std::string, std::string, int>, std::uint64_t> requests_;
  std::array<std::uint64_t, kBounds.size() + 1> times_{};  // per bound, and above all
  double seconds_ = 0;
  std::uint64_t bytes_in_ = 0, bytes_out_ = 0;
};

}  // namespace regarment
