#include "http/request.h"

#include <gtest/gtest.h>

#include "http/problem.h"

namespace regarment {
namespace {

Request read(std::string_view target) {
  Request request;
  read_target(target, request);
  return request;
}

TEST(ReadTarget, DecodesSegmentsAndQuery) {
  const Request request = read("/v1/jobs/a%20b%C3%A4?text=%41+b%2Bc&empty=&flag");
  EXPECT_EQ(request.path, (std::vector<std::string>{"v1", "jobs", "a b\xC3\xA4"}));
  EXPECT_EQ(request.query,
            (std::map<std::string, std::string>{{"text", "A b+c"}, {"empty", ""}, {"flag", ""}}));
}

TEST(ReadTarget, TheRootHasNoSegmentsAndAPlusInAPathStays) {
  EXPECT_TRUE(read("/").path.empty());
  EXPECT_EQ(read("/a+b/").path, std::vector<std::string>{"a+b"});
}

TEST(ReadTarget, RefusesWhatCouldLeadElsewhere) {
  for (const char* target :
       {"",         "v1",        "http://host/", "*",      "//",     "/a//b",    "/a/../b",
        "/a/./b",   "/%2e%2e/b", "/...",         "/a%2fb", "/a%5Cb", "/a\\b",    "/a%00",
        "/a%0d%0a", "/%",        "/%4",          "/%zz",   "/a#b",   "/a?b=%1f", "/a?b=1&b=2"}) {
    try {
      read(target);
      ADD_FAILURE() << target;
    } catch (const HttpProblem& problem) {
      EXPECT_EQ(problem.status, 400) << target;
      EXPECT_EQ(problem.code, "bad_target") << target;
    }
  }
}

TEST(RequestIds, AreNeverTheSame) {
  RequestIds one, other;
  EXPECT_NE(one.next(), one.next());
  EXPECT_EQ(one.next().substr(0, 9), one.next().substr(0, 9));
}

}  // namespace
}  // namespace regarment
