#include "report/text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regarment {
namespace {

TEST(Text, CentimetresHaveOneDigitAndNoMinusZero) {
  EXPECT_EQ(cm_text(0.5437), "54.4");
  EXPECT_EQ(cm_text(-0.0002), "0.0");
  EXPECT_EQ(cm_text(1.0), "100.0");
}

TEST(Text, SignsAreWrittenOut) {
  EXPECT_EQ(signed_cm_text(0.012), "+1.2");
  EXPECT_EQ(signed_cm_text(-0.004), "\u22120.4");
  EXPECT_EQ(signed_cm_text(-0.0001), "0.0");
}

TEST(Text, NotANumberIsAQuestion) { EXPECT_EQ(fixed_text(std::nan(""), 1), "?"); }

TEST(Text, SignificantDigitsCountFromTheFirstThatIsNotZero) {
  EXPECT_EQ(significant_text(0.0123456, 3), "0.0123");
  EXPECT_EQ(significant_text(1234.6, 3), "1235");
  EXPECT_EQ(significant_text(12.345, 3), "12.3");
  EXPECT_EQ(significant_text(-0.5, 2), "-0.50");
  EXPECT_EQ(significant_text(0.0, 3), "0");
  EXPECT_EQ(significant_text(1e-20, 3), "0.000000000000");
  EXPECT_DOUBLE_EQ(rounded_significant(0.001234567, 4), 0.001235);
}

TEST(Text, ShortNumbersHaveNoDigitsThatSayNothing) {
  EXPECT_EQ(short_text(5.0), "5");
  EXPECT_EQ(short_text(-1.5), "-1.5");
  EXPECT_EQ(short_text(0.97), "0.97");
  EXPECT_EQ(short_text(0.0), "0");
  EXPECT_EQ(short_text(1.23456), "1.235");
}

TEST(Text, CountsAreGroupedByThree) {
  EXPECT_EQ(count_text(7), "7");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1000), "1\u202f000");
  EXPECT_EQ(count_text(1234567), "1\u202f234\u202f567");
}

TEST(Text, ShellQuotingKeepsPlainWordsAndGuardsTheRest) {
  EXPECT_EQ(shell_quoted("scan-1.ply"), "scan-1.ply");
  EXPECT_EQ(shell_quoted("a b"), "'a b'");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_quoted("$(rm)"), "'$(rm)'");
  EXPECT_EQ(shell_quoted(""), "''");
}

// The examples of RFC 4648, section 10.
TEST(Text, Base64AgreesWithItsStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Text, RoundingNeverGivesMinusZero) {
  EXPECT_FALSE(std::signbit(rounded(-0.00001, 3)));
  EXPECT_DOUBLE_EQ(rounded(1.23456, 2), 1.23);
}

}  // namespace
}  // namespace regarment
