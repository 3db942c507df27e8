// What needs no server: texts and addresses.

#include "jobs/postgres_text.h"

#include <gtest/gtest.h>
#include <iconv.h>

#include <random>

#include "base/error.h"
#include "jobs/job_store.h"
#include "jobs/postgres_address.h"

namespace regarment {
namespace {

// What the C library takes for UTF-8.
bool is_utf8(std::string text) {
  const iconv_t converter = ::iconv_open("UTF-32LE", "UTF-8");
  std::string out(4 * text.size() + 4, ' ');
  char *from = text.data(), *to = out.data();
  std::size_t left = text.size(), room = out.size();
  const bool good = ::iconv(converter, &from, &left, &to, &room) != static_cast<std::size_t>(-1);
  ::iconv_close(converter);
  return good && left == 0;
}

TEST(PostgresText, IsUtf8WithoutZeroBytesAndComesBackAsItWas) {
  std::mt19937 dice(1);
  // Bytes that make and break characters, drawn often.
  constexpr std::string_view kPieces(
      "\x00\x1a"
      "1a\x7f\x80\x9f\xa0\xbf\xc0\xc2\xe0\xe2\xed\xef\xf0\xf4\xf5\xff",
      18);
  for (int round = 0; round < 20000; ++round) {
    std::string bytes(round % 9, ' ');
    for (char& c : bytes) c = kPieces[dice() % kPieces.size()];
    const std::string text = postgres_text(bytes);
    ASSERT_TRUE(is_utf8(text));
    ASSERT_EQ(text.find('\0'), std::string::npos);
    ASSERT_EQ(bytes_of_postgres_text(text), bytes);
    if (is_utf8(bytes) && bytes.find_first_of(std::string_view("\0\x1a", 2)) == std::string::npos) {
      ASSERT_EQ(text, bytes);
    }
  }
}

TEST(PostgresText, NumbersTheValuesOfAStatement) {
  EXPECT_EQ(postgres_statement("SELECT a FROM b WHERE c = ? AND d IN (?, ?)"),
            "SELECT a FROM b WHERE c = $1 AND d IN ($2, $3)");
  EXPECT_EQ(postgres_tables("CREATE TABLE t (n INTEGER PRIMARY KEY AUTOINCREMENT, m INTEGER, "
                            "r REAL, s TEXT UNIQUE) WITHOUT ROWID"),
            "CREATE TABLE t (n BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY, m BIGINT, "
            "r DOUBLE PRECISION, s TEXT COLLATE \"C\" UNIQUE)");
}

TEST(PostgresAddress, IsShownWithoutItsSecrets) {
  EXPECT_EQ(shown_store("postgresql://anna:s3cret@db.example:5433/scans?sslmode=require"),
            "postgresql://anna@db.example:5433/scans");
  EXPECT_EQ(shown_store("postgres://db/scans?user=anna&password=s3cret&sslpassword=s3cret"),
            "postgresql://anna@db/scans");
  EXPECT_EQ(shown_store("postgresql://anna:s3cret@a:1,b:2/scans"),
            "postgresql://anna@a,b:1,2/scans");
  EXPECT_EQ(shown_store("postgresql://anna:s3cret@db:port:x/?bad=%zz"), "postgresql://...");
  EXPECT_EQ(shown_store("mysql://anna:s3cret@db"), "mysql://...");
  EXPECT_EQ(shown_store("a folder/store.sqlite3"), "a folder/store.sqlite3");
}

TEST(PostgresAddress, IsNotRepeatedInARefusal) {
  for (const char* bad : {"postgresql://anna:s3cret@db:1/x?nothing=1", "postgresql://[anna:s3cret",
                          "postgresql://anna:s3cret@db/%zz"}) {
    try {
      open_job_store(bad);
      ADD_FAILURE() << bad;
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string_view(error.what()).find("s3cret"), std::string_view::npos);
    }
  }
}

// Port 1 of this machine is nobody's.
TEST(PostgresAddress, SaysWhenNobodyIsThere) {
  try {
    open_job_store("postgresql://anna:s3cret@127.0.0.1:1/scans");
    ADD_FAILURE();
  } catch (const TemporaryError& error) {
    const std::string_view what = error.what();
    EXPECT_NE(what.find("postgresql://anna@127.0.0.1:1/scans"), std::string_view::npos);
    EXPECT_EQ(what.find("s3cret"), std::string_view::npos);
    EXPECT_EQ(what.find('\n'), std::string_view::npos);
  }
}

TEST(PostgresAddress, KeepsQuotesOfItsPartsInTheConnection) {
  EXPECT_NE(
      PostgresAddress::parse("postgresql://a%27b%5Cc@h/d").connection.find(R"(user='a\'b\\c')"),
      std::string::npos);
}

}  // namespace
}  // namespace regarment
