#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "http/headers.h"

namespace regarment {

/// What stands before a request's body.
struct Request {
  std::string method;                        // "GET"
  std::vector<std::string> path;             // segments, decoded: "/v1/jobs/a" is v1, jobs, a
  std::map<std::string, std::string> query;  // decoded
  Headers headers;
  std::string id;  // made by the server, for logs and answers
};

/// Takes a request target apart. Segments and values are percent-decoded (a plus sign in a query is
/// a space). Throws HttpProblem 400 "bad_target" when it does not begin with "/", has a fragment,
/// a bad percent sign, a control character, an encoded slash, an empty segment but the last, a
/// segment of dots alone, or a query name twice.
void read_target(std::string_view target, Request& request);

/// What the header of a request must hold beside its form: one Host (of HTTP/1.1), no transfer
/// encoding but chunked, no expectation but 100-continue. Throws HttpProblem.
void check_header(const Request& request, bool http_1_1, bool chunked);

/// Ids of requests, never the same twice: a random number of this server, then a count.
class RequestIds {
 public:
  RequestIds();
  /// Any thread.
  std::string next();

 private:
  std::string prefix_;  // eight hexadecimal digits and a dash
  std::atomic<std::uint64_t> count_{0};
};

}  // namespace regarment
