#include "service/route.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

std::vector<Route> made_routes() {
  std::vector<Route> out;
  for (const auto& [method, pattern] :
       std::vector<std::pair<std::string, std::string>>{{"GET", "/"},
                                                        {"GET", "/v1/jobs"},
                                                        {"POST", "/v1/jobs"},
                                                        {"GET", "/v1/jobs/{id}/events"},
                                                        {"GET", "/v1/jobs/{id}/{file...}"},
                                                        {"DELETE", "/v1/jobs/{id}"}}) {
    Route route;
    route.method = method;
    route.pattern = pattern;
    out.push_back(route);
  }
  return out;
}

FoundRoute find(const std::vector<Route>& routes, const std::string& method,
                const std::string& target) {
  Request request;
  request.method = method;
  read_target(target, request);
  return find_route(routes, request);
}

TEST(FindRoute, CapturesSegments) {
  const std::vector<Route> routes = made_routes();
  EXPECT_EQ(find(routes, "GET", "/").route, &routes[0]);
  EXPECT_EQ(find(routes, "HEAD", "/v1/jobs?x=1").route, &routes[1]);
  EXPECT_EQ(find(routes, "GET", "/v1/jobs/a/events").route, &routes[3]);
  const FoundRoute file = find(routes, "GET", "/v1/jobs/a/pictures/b.png");
  EXPECT_EQ(file.route, &routes[4]);
  EXPECT_EQ(file.captured, (std::vector<std::string>{"a", "pictures", "b.png"}));
}

TEST(FindRoute, TellsWhichMethodsThereAre) {
  const std::vector<Route> routes = made_routes();
  EXPECT_EQ(find(routes, "PUT", "/v1/jobs").allowed, "GET, HEAD, POST");
  EXPECT_EQ(find(routes, "GET", "/v1/jobs/a").allowed, "DELETE");
  for (const char* nowhere : {"/v1", "/v2/jobs", "/v1/jobs/a/b/c/d?"}) {
    const FoundRoute found = find(routes, "POST", nowhere);
    EXPECT_EQ(found.route, nullptr) << nowhere;
  }
  EXPECT_EQ(find(routes, "GET", "/v1").allowed, "");
}

}  // namespace
}  // namespace regarment
