#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace regarment {

/// One connection to an SQLite file, each commit durable (synchronous FULL), what is
/// deleted overwritten. One thread at a time. Everything that talks to it throws TemporaryError
/// where the disk is full, the file away or locked for more than ten seconds, ReadError where it is
/// damaged, InvalidInput for wrong SQL.
class SqliteDatabase {
 public:
  /// Opens the file, or makes it, readable to its owner only, with its folder. Throws UsageError
  /// when it is no SQLite file or may not be written.
  explicit SqliteDatabase(const std::filesystem::path& file);
  ~SqliteDatabase();
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  /// Lets several processes share the file: write-ahead logging. Throws UsageError where the file
  /// system cannot do that.
  void share();
  /// Moves what the log holds into the file, as far as nobody reads it, so that what was deleted is
  /// nowhere any more.
  void empty_log();
  /// Runs statements that give no rows.
  void run(const std::string& sql);
  /// A number from a statement that gives one.
  std::int64_t number(const std::string& sql);
  /// Rows that the last statement changed.
  int changes() const;
  /// Throws what the result code of the library asks for, unless it is a good one.
  void check(int code) const;

  const std::filesystem::path& file() const { return file_; }

 private:
  friend class SqliteStatement;
  friend class SqliteTransaction;

  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// A statement with its values, each in the place of a "?". Lives no longer than the database.
class SqliteStatement {
 public:
  template <typename... Values>
  SqliteStatement(SqliteDatabase& database, std::string_view sql, const Values&... values)
      : SqliteStatement(database, sql) {
    (bind(values), ...);
  }
  SqliteStatement(SqliteDatabase& database, std::string_view sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  // The next "?". Text longer than 1 MiB throws InvalidInput.
  void bind(std::int64_t value);
  void bind(int value) { bind(static_cast<std::int64_t>(value)); }
  void bind(std::uint64_t value) { bind(static_cast<std::int64_t>(value)); }
  void bind(double value);
  void bind(std::string_view value);
  void bind(const std::string& value) { bind(std::string_view(value)); }
  void bind(const char* value) { bind(std::string_view(value)); }

  /// Goes to the next row; false after the last.
  bool step();
  /// Steps to the end.
  void run();

  // Of the row it is at; columns count from 0. Null reads as 0 and as empty text.
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  bool is_null(int column) const;

 private:
  SqliteDatabase& database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

/// A transaction that writes: begun here, gone without a trace unless committed.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  SqliteDatabase& database_;
};

}  // namespace regarment
