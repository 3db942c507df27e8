#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "jobs/job.h"

namespace regarment {

/// A statement on its way through a database of some kind; used through SqlStatement.
class SqlCursor {
 public:
  virtual ~SqlCursor() = default;
  // The next "?".
  virtual void bind_integer(std::int64_t value) = 0;
  virtual void bind_real(double value) = 0;
  virtual void bind_text(std::string_view value) = 0;
  virtual bool step() = 0;
  virtual std::int64_t integer(int column) const = 0;
  virtual double real(int column) const = 0;
  virtual std::string text(int column) const = 0;
  virtual bool is_null(int column) const = 0;
};

/// One connection to a database, each commit durable. One thread at a time, but for `now`. What
/// talks to it throws TemporaryError where the database is full, away or locked for more than ten
/// seconds, ReadError where it is damaged, InvalidInput for wrong SQL. The SQL is what SQLite and
/// PostgreSQL both understand, but for what this class hides: a value is a "?", tables are declared
/// in SQLite's words, and rows are locked as the two functions below say.
class SqlDatabase {
 public:
  virtual ~SqlDatabase() = default;

  /// What it is called in messages; holds no password.
  virtual std::string name() const = 0;
  virtual std::unique_ptr<SqlCursor> prepare(std::string_view sql) = 0;
  /// Runs statements that give no rows and have no values.
  virtual void run(const std::string& sql) = 0;

  virtual void begin() = 0;
  /// Nothing was kept where it throws.
  virtual void commit() = 0;
  /// Nothing when no transaction is open.
  virtual void rollback() noexcept = 0;

  /// The end of a SELECT of `jobs` whose rows nobody else may change before the transaction ends;
  /// empty where a transaction has the whole database anyway.
  virtual const char* locking() const = 0;
  /// The same, leaving out rows that somebody else has locked.
  virtual const char* locking_free_ones() const = 0;

  /// The time that all who share the database agree on.
  virtual JobTime now() const = 0;

  // For migrations (store_schema.h).
  /// Number of steps that have been made; 0: it is empty. Throws UsageError when what is there
  /// belongs to another program.
  virtual int schema_version() = 0;
  virtual void set_schema_version(int version) = 0;
  /// Makes it fit for several processes; before the first transaction. Throws UsageError where that
  /// cannot be.
  virtual void share() {}
  /// Within a transaction: nobody else migrates until it ends.
  virtual void lock_schema() {}
  /// What was deleted is not to be found in the files any more, as far as that can be had now.
  virtual void wipe_deleted() {}

  /// A number from a statement that gives one.
  std::int64_t number(std::string_view sql);
};

/// A statement with its values, each in the place of a "?". Lives no longer than the database.
class SqlStatement {
 public:
  template <typename... Values>
  SqlStatement(SqlDatabase& database, std::string_view sql, const Values&... values)
      : SqlStatement(database, sql) {
    (bind(values), ...);
  }
  SqlStatement(SqlDatabase& database, std::string_view sql) : cursor_(database.prepare(sql)) {}

  // The next "?". Text longer than 1 MiB throws InvalidInput.
  void bind(std::int64_t value) { cursor_->bind_integer(value); }
  void bind(int value) { cursor_->bind_integer(value); }
  void bind(std::uint64_t value) { cursor_->bind_integer(static_cast<std::int64_t>(value)); }
  void bind(double value) { cursor_->bind_real(value); }
  void bind(std::string_view value);
  void bind(const std::string& value) { bind(std::string_view(value)); }
  void bind(const char* value) { bind(std::string_view(value)); }

  /// Goes to the next row; false after the last.
  bool step() { return cursor_->step(); }
  /// Steps to the end.
  void run();

  // Of the row it is at; columns count from 0. Null reads as 0 and as empty text.
  std::int64_t integer(int column) const { return cursor_->integer(column); }
  double real(int column) const { return cursor_->real(column); }
  std::string text(int column) const { return cursor_->text(column); }
  bool is_null(int column) const { return cursor_->is_null(column); }

 private:
  std::unique_ptr<SqlCursor> cursor_;
};

/// A transaction that writes: begun here, gone without a trace unless committed.
class SqlTransaction {
 public:
  explicit SqlTransaction(SqlDatabase& database) : database_(database) { database_.begin(); }
  ~SqlTransaction() { database_.rollback(); }
  SqlTransaction(const SqlTransaction&) = delete;
  SqlTransaction& operator=(const SqlTransaction&) = delete;

  void commit() { database_.commit(); }

 private:
  SqlDatabase& database_;
};

}  // namespace regarment
