#pragma once

#include <filesystem>

#include "jobs/sql_database.h"

struct sqlite3;

namespace regarment {

/// One connection to an SQLite file, each commit durable (synchronous FULL), what is deleted
/// overwritten.
class SqliteDatabase : public SqlDatabase {
 public:
  /// Opens the file, or makes it, readable to its owner only, with its folder. Throws UsageError
  /// when it is no SQLite file or may not be written.
  explicit SqliteDatabase(const std::filesystem::path& file);
  ~SqliteDatabase() override;
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  std::string name() const override;
  std::unique_ptr<SqlCursor> prepare(std::string_view sql) override;
  void run(const std::string& sql) override;
  void begin() override { run("BEGIN IMMEDIATE"); }
  void commit() override { run("COMMIT"); }
  void rollback() noexcept override;
  // A transaction that writes has the file for itself.
  const char* locking() const override { return ""; }
  const char* locking_free_ones() const override { return ""; }
  JobTime now() const override { return system_time(); }
  int schema_version() override;
  void set_schema_version(int version) override;
  /// Write-ahead logging; a file system without shared memory cannot do that.
  void share() override;
  /// Moves what the log holds into the file, as far as nobody reads it.
  void wipe_deleted() override;

  /// Throws what the result code of the library asks for, unless it is a good one.
  void check(int code) const;

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

}  // namespace regarment
