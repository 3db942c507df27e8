#include "http/conditional.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

std::string asked(Headers headers, std::uint64_t size = 1000, std::string method = "GET") {
  Request request;
  request.method = std::move(method);
  request.headers = std::move(headers);
  const auto answer = asked_range(request, size, "\"tag\"");
  if (std::holds_alternative<WholeFile>(answer)) return "whole";
  if (std::holds_alternative<NoSuchRange>(answer)) return "none";
  const auto [begin, end] = std::get<ByteRange>(answer);
  return std::to_string(begin) + "," + std::to_string(end);
}

// RFC 9110, 14.1.2 gives the examples of a file of 10,000 bytes.
TEST(AskedRange, IsWhatTheStandardSays) {
  EXPECT_EQ(asked({{"Range", "bytes=0-499"}}, 10000), "0,500");
  EXPECT_EQ(asked({{"Range", "bytes=500-999"}}, 10000), "500,1000");
  EXPECT_EQ(asked({{"Range", "bytes=-500"}}, 10000), "9500,10000");
  EXPECT_EQ(asked({{"Range", "bytes=9500-"}}, 10000), "9500,10000");
}

TEST(AskedRange, StaysInTheFile) {
  EXPECT_EQ(asked({{"Range", "bytes=990-5000"}}), "990,1000");
  EXPECT_EQ(asked({{"Range", "bytes=-5000"}}), "0,1000");
  EXPECT_EQ(asked({{"Range", "bytes=5-99999999999999999999999"}}), "5,1000");
  EXPECT_EQ(asked({{"Range", "bytes=1000-"}}), "none");
  EXPECT_EQ(asked({{"Range", "bytes=99999999999999999999-"}}), "none");
  EXPECT_EQ(asked({{"Range", "bytes=-0"}}), "none");
  EXPECT_EQ(asked({{"Range", "bytes=0-"}}, 0), "none");
  EXPECT_EQ(asked({{"Range", "bytes=-1"}}, 0), "none");
}

TEST(AskedRange, AsksForTheWholeWhenItIsNoSingleRange) {
  for (const char* value : {"bytes=0-1,5-6", "bytes=5-1", "bytes=", "bytes=-", "bytes=a-b", "0-1",
                            "lines=0-1", "bytes=1", "bytes=--1", "bytes=+1-2"})
    EXPECT_EQ(asked({{"Range", value}}), "whole") << value;
  EXPECT_EQ(asked({}), "whole");
  EXPECT_EQ(asked({{"Range", "bytes=0-1"}}, 1000, "HEAD"), "whole");
  EXPECT_EQ(asked({{"Range", "bytes=0-1"}, {"Range", "bytes=0-1"}}), "whole");
}

TEST(AskedRange, CountsOnlyForTheFileThatIfRangeNames) {
  EXPECT_EQ(asked({{"Range", "bytes=0-1"}, {"If-Range", "\"tag\""}}), "0,2");
  EXPECT_EQ(asked({{"Range", "bytes=0-1"}, {"If-Range", "\"old\""}}), "whole");
  EXPECT_EQ(asked({{"Range", "bytes=0-1"}, {"If-Range", "W/\"tag\""}}), "whole");
}

TEST(HasEtag, ComparesWeakly) {
  Request request;
  EXPECT_FALSE(has_etag(request, "\"a\""));
  request.headers = {{"If-None-Match", "\"b\", W/\"a\""}};
  EXPECT_TRUE(has_etag(request, "\"a\""));
  EXPECT_FALSE(has_etag(request, "\"c\""));
  request.headers = {{"If-None-Match", "*"}};
  EXPECT_TRUE(has_etag(request, "\"c\""));
}

}  // namespace
}  // namespace regarment
