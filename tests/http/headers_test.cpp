#include "http/headers.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

TEST(Headers, AreFoundWhateverTheCaseOfTheirNames) {
  const Headers headers{{"Content-Type", "text/plain"}, {"X-A", "1"}, {"x-a", "2"}};
  EXPECT_EQ(headers.get("content-TYPE"), "text/plain");
  EXPECT_EQ(headers.get("X-A"), "1");
  EXPECT_EQ(headers.count("x-A"), 2U);
  EXPECT_FALSE(headers.find("Content-Typ"));
  EXPECT_EQ(headers.get("missing"), "");
}

TEST(Headers, ListsLoseSpacesAndEmptyMembers) {
  EXPECT_EQ(list_members(" a ,, b c\t,"), (std::vector<std::string_view>{"a", "b c"}));
  EXPECT_TRUE(list_members("  , ").empty());
}

TEST(HeaderParameter, IsATokenOrQuotedText) {
  EXPECT_EQ(header_parameter("form-data; name=scan", "name"), "scan");
  EXPECT_EQ(header_parameter("form-data; name=\"a; b=\\\"c\\\\\"; filename=x", "name"),
            "a; b=\"c\\");
  EXPECT_EQ(header_parameter("form-data; name=\"a\" ; FileName=\"b\"", "filename"), "b");
  EXPECT_EQ(header_parameter("form-data; name=\"\"", "name"), "");
}

TEST(HeaderParameter, IsNothingWhenAbsentTwiceOrBroken) {
  for (const char* value :
       {"form-data", "form-data; other=1", "form-data; name=a; name=b", "form-data; name=\"a",
        "form-data; name=\"a\\", "form-data; name=\"a\"b", "form-data; name",
        "form-data; name=", "form-data; name=a b", "form-data; =a"})
    EXPECT_EQ(header_parameter(value, "name"), std::nullopt) << value;
}

}  // namespace
}  // namespace regarment
