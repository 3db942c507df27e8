#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "http/server.h"
#include "service/caller.h"

namespace regarment {

/// A request on its way to the function that answers it.
struct Call {
  Request request;
  Caller caller;
  std::vector<std::string> captured;  // what stands where the pattern has {...}
  std::string body;                   // whole, at most the route's body_limit
};

/// One method of one path. Of `answer` and `upload` exactly one is set.
struct Route {
  std::string method;         // GET answers HEAD too
  std::string pattern;        // "/v1/jobs/{id}/{file...}": one segment, or one and all after it
  std::optional<Scope> need;  // any of `need` or Admin; none: whoever is admitted
  std::function<Response(const Call&)> answer;
  std::uint64_t body_limit = 0;                                       // bytes, of `answer`
  std::function<std::unique_ptr<Exchange>(const Call&)> upload = {};  // takes the body as it comes
  bool open = false;  // answered to everybody, without a key and by any host's name
};

/// What a path means: a route, or the methods it has.
struct FoundRoute {
  const Route* route = nullptr;
  std::vector<std::string> captured;
  std::string allowed;  // "GET, HEAD, DELETE"; empty: no such path
};

/// The first route that fits, in their order.
FoundRoute find_route(const std::vector<Route>& routes, const Request& request);

/// An exchange that gathers the body and calls `route.answer`. Throws 415 when a body is announced
/// that is neither JSON nor text. The route outlives it.
std::unique_ptr<Exchange> gathered(const Route& route, Call call);

}  // namespace regarment
