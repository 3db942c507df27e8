#include "report/csv_table.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/texts.h"

namespace regarment {
namespace {

CsvTable parse(const std::string& text) { return CsvTable::parse(text, "t.csv"); }

std::string error_of(const std::string& text) {
  return refusal_of<ReadError>([&] { parse(text); });
}

TEST(CsvTable, ReadsByColumnNameWhateverTheOrder) {
  const CsvTable table = parse("b,a\n2,1\n4,3\n");
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.cell(0, "a"), "1");
  EXPECT_EQ(table.cell(1, "b"), "4");
  EXPECT_EQ(table.cell(1, "none"), "");
  EXPECT_EQ(table.line(1), 3u);
}

TEST(CsvTable, UnderstandsQuotesLineEndsMarksAndSpaces) {
  const CsvTable table = parse(
      "\xef\xbb\xbf"
      "a,b\r\n\"x, \"\"y\"\"\nz\", 2 \r\n\r\nlast,3");
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.cell(0, "a"), "x, \"y\"\nz");
  EXPECT_EQ(table.cell(0, "b"), "2");
  EXPECT_EQ(table.cell(1, "a"), "last");
  EXPECT_EQ(table.line(1), 5u);
}

TEST(CsvTable, ReadsBackWhatIsWrittenExactly) {
  for (const std::string text :
       {"=cmd()", "+1", "a,b", "the \"one\"", "two\nlines", "'", "plain"}) {
    EXPECT_EQ(parse("a,b\n" + csv_exact(text) + ",1\n").cell(0, "a"), text);
  }
}

TEST(CsvTable, ReadsNumbersAndEmptyCells) {
  const CsvTable table = parse("a\n-1.5e1\n+2\n");
  EXPECT_DOUBLE_EQ(*table.number(0, "a"), -15.0);
  EXPECT_DOUBLE_EQ(*table.number(1, "a"), 2.0);
  EXPECT_FALSE(table.number(0, "b").has_value());
}

TEST(CsvTable, NamesLineAndColumnOfAWrongNumber) {
  for (const std::string bad :
       {"54,5", "12cm", "nan", "inf", "1e999", "0x10", "--1", "+-1", "1 2"}) {
    const CsvTable table = parse("x,value_cm\n1,1\n1,\"" + bad + "\"\n");
    try {
      (void)table.number(1, "value_cm");
      FAIL() << bad;
    } catch (const ReadError& error) {
      EXPECT_NE(std::string(error.what()).find("t.csv: line 3, column value_cm"),
                std::string::npos);
    }
  }
}

TEST(CsvTable, RefusesWhatIsNoTable) {
  EXPECT_NE(error_of("").find("is empty"), std::string::npos);
  EXPECT_NE(error_of("\n\n").find("is empty"), std::string::npos);
  EXPECT_NE(error_of("a,b\n1\n").find("line 2 has 1 cells"), std::string::npos);
  EXPECT_NE(error_of("a,b\n1,2,3\n").find("line 2 has 3 cells"), std::string::npos);
  EXPECT_NE(error_of("a,a\n1,2\n").find("twice"), std::string::npos);
  EXPECT_NE(error_of("a\n\"1\n2\n").find("line 2: a quote is opened"), std::string::npos);
  EXPECT_NE(error_of("a\n1\"2\n").find("line 2: a quote inside"), std::string::npos);
  EXPECT_NE(error_of("a\n\"1\"2\n").find("after a closing quote"), std::string::npos);
  EXPECT_NE(error_of(std::string("a\n1\0\n", 5)).find("NUL"), std::string::npos);
  EXPECT_NE(error_of(std::string((16u << 20) + 1, 'a')).find("16 MiB"), std::string::npos);
}

TEST(CsvText, GuardsFormulasAndQuotes) {
  EXPECT_EQ(csv_text("waist"), "waist");
  EXPECT_EQ(csv_text("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_text("say \"x\""), "\"say \"\"x\"\"\"");
  for (const std::string start : {"=", "+", "-", "@", "\t", "\r"}) {
    EXPECT_TRUE(csv_text(start + "cmd()").starts_with("\"'")) << start;
  }
}

TEST(CsvText, ComesBackAsItWas) {
  const std::string nasty = "a \"b\", c\nd";
  EXPECT_EQ(parse("x\n" + csv_text(nasty) + "\n").cell(0, "x"), nasty);
}

}  // namespace
}  // namespace regarment
