#include "service/route.h"

#include <algorithm>

namespace regarment {
namespace {

std::vector<std::string> segments_of(const std::string& pattern) {
  Request request;
  read_target(pattern, request);
  return request.path;
}

// What stands where the pattern has braces, or nothing when the path does not fit.
std::optional<std::vector<std::string>> fitted(const std::string& pattern,
                                               const std::vector<std::string>& path) {
  const std::vector<std::string> wanted = segments_of(pattern);
  std::vector<std::string> captured;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i >= path.size()) return std::nullopt;
    if (wanted[i].ends_with("...}")) {
      captured.insert(captured.end(), path.begin() + static_cast<std::ptrdiff_t>(i), path.end());
      return captured;
    }
    if (wanted[i].starts_with('{'))
      captured.push_back(path[i]);
    else if (wanted[i] != path[i])
      return std::nullopt;
  }
  if (path.size() != wanted.size()) return std::nullopt;
  return captured;
}

void allow(std::string& methods, const std::string& method) {
  if (methods.find(method) != std::string::npos) return;
  methods += (methods.empty() ? "" : ", ") + method;
  if (method == "GET") methods += ", HEAD";
}

class Gathered : public Exchange {
 public:
  Gathered(const Route& route, Call call) : route_(route), call_(std::move(call)) {}
  std::uint64_t body_limit() const override { return route_.body_limit; }
  void take(std::string_view bytes) override { call_.body.append(bytes); }
  Response finish() override { return route_.answer(call_); }

 private:
  const Route& route_;
  Call call_;
};

}  // namespace

FoundRoute find_route(const std::vector<Route>& routes, const Request& request) {
  FoundRoute out;
  const std::string method = request.method == "HEAD" ? "GET" : request.method;
  for (const Route& route : routes) {
    const auto captured = fitted(route.pattern, request.path);
    if (!captured) continue;
    if (route.method == method) return {&route, *captured, {}};
    allow(out.allowed, route.method);
  }
  return out;
}

std::unique_ptr<Exchange> gathered(const Route& route, Call call) {
  const std::string_view type = call.request.headers.get("Content-Type");
  const std::string_view plain = trimmed(type.substr(0, type.find(';')));
  if (route.body_limit > 0 && !plain.empty() && !same_ignoring_case(plain, "application/json"))
    throw HttpProblem(415, "not_json", "the body must be application/json");
  return std::make_unique<Gathered>(route, std::move(call));
}

}  // namespace regarment
