#include "base/one_line.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

TEST(OneLine, KeepsPlainTextAndLetters) {
  EXPECT_EQ(one_line("skirt 1.ply"), "skirt 1.ply");
  EXPECT_EQ(one_line("J\xc3\xbcrgen \xe4\xba\xba \xf0\x9f\x91\x97"),
            "J\xc3\xbcrgen \xe4\xba\xba \xf0\x9f\x91\x97");
}

TEST(OneLine, EscapesControlCharacters) {
  using namespace std::string_literals;
  EXPECT_EQ(one_line("a\nb\tc\x1b[31m\x7f"), "a\\x0ab\\x09c\\x1b[31m\\x7f");
  EXPECT_EQ(one_line("a\0b"s), "a\\x00b");
}

TEST(OneLine, EscapesWhatATerminalWouldObeyInUtf8) {
  EXPECT_EQ(one_line("\xc2\x85"), "\\xc2\\x85");           // next line, a C1 control
  EXPECT_EQ(one_line("\xe2\x80\xa8"), "\\xe2\\x80\\xa8");  // line separator
  EXPECT_EQ(one_line("\xe2\x80\xae"), "\\xe2\\x80\\xae");  // right-to-left override
}

TEST(OneLine, EscapesBrokenUtf8) {
  EXPECT_EQ(one_line("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(one_line("\xc3"), "\\xc3");                             // cut short
  EXPECT_EQ(one_line("\xc0\x8a"), "\\xc0\\x8a");                    // overlong line feed
  EXPECT_EQ(one_line("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // surrogate
  EXPECT_EQ(one_line("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // past the last code point
}

TEST(OneLine, CutsLongText) {
  EXPECT_EQ(one_line("abcdef", 6), "abcdef");
  EXPECT_EQ(one_line("abcdefg", 6), "abcdef...");
}

}  // namespace
}  // namespace regarment
