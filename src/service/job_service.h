#pragma once

#include <iosfwd>
#include <mutex>
#include <vector>

#include "service/access.h"
#include "service/metrics.h"
#include "service/route.h"

namespace regarment {

/// Answers the requests of a server: finds the route, asks who may, hands on; counts and logs.
class JobService : public Handler {
 public:
  /// One line of JSON per request goes to `log`, without anything of a scan: neither paths, names
  /// nor queries as they were written. All that is handed in outlives the service.
  JobService(const Service& service, std::ostream& log);

  /// More routes, tried after those of the API. Before the server begins.
  void add(std::vector<Route> routes);
  Access& access() { return access_; }

  std::optional<Response> at_once(const Request& request) override;
  std::unique_ptr<Exchange> begin(const Request& request) override;
  void served(const Request* request, const Served& served) override;

 private:
  Access access_;
  Metrics metrics_;
  std::vector<Route> routes_;
  std::mutex log_mutex_;
  std::ostream& log_;
};

/// A line of the log: {"time", "level", "event", ...}.
std::string log_line(std::string_view level, std::string_view event,
                     const std::vector<std::pair<std::string, std::string>>& facts);

}  // namespace regarment
