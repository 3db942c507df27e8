#include "http/address.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

TEST(HttpAddress, HasAHostAndAPort) {
  const std::pair<const char*, const char*> cases[] = {
      {"http://studio", "http://studio:80"},
      {"https://studio.example/", "https://studio.example:443"},
      {"http://127.0.0.1:8080", "http://127.0.0.1:8080"},
      {"https://[::1]:65535/", "https://[::1]:65535"}};
  for (const auto& [text, whole] : cases) {
    const HttpAddress address = HttpAddress::parse(text);
    EXPECT_EQ(address.text(), whole);
    EXPECT_EQ(HttpAddress::parse(address.text()).text(), whole);
  }
}

TEST(HttpAddress, IsNothingElseAndRepeatsNoPassword) {
  for (const char* text :
       {"",           "studio",         "ftp://studio", "HTTP://studio",        "http://",
        "http://:80", "http://a:",      "http://a:0",   "http://a:65536",       "http://a:8x",
        "http://a/b", "http://a?b",     "http://a#b",   "http://user:secret@a", "http://[::1",
        "http://[a]", "http://[::1]80", "http://a b",   "http://a\r\nHost: b",  "http://a//"})
    try {
      HttpAddress::parse(text);
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string(error.what()).find("secret"), std::string::npos);
    }
}

TEST(HttpAddress, KnowsWhatStaysOnThisMachine) {
  for (const char* text : {"http://localhost", "http://127.3.2.1:8080", "http://[::1]"})
    EXPECT_TRUE(HttpAddress::parse(text).is_loopback()) << text;
  for (const char* text : {"http://127.example", "http://10.0.0.1", "http://[fe80::1]", "http://a"})
    EXPECT_FALSE(HttpAddress::parse(text).is_loopback()) << text;
}

}  // namespace
}  // namespace regarment
