#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "jobs/postgres_address.h"
#include "jobs/sql_database.h"

namespace regarment {

/// One connection to a PostgreSQL database, version 13 or newer. Our tables lie in its schema
/// "regarment". A connection that was lost is made anew by the next call that needs it; what can be
/// repeated without harm (a read, the beginning of a transaction) is repeated at once, a
/// transaction that was under way is gone. Where the connection breaks during a commit, the server
/// is asked what became of it, for ten seconds at most.
class PostgresDatabase : public SqlDatabase {
 public:
  /// Throws UsageError when the server refuses us or cannot serve, TemporaryError when it is away.
  explicit PostgresDatabase(PostgresAddress address);
  ~PostgresDatabase() override;
  PostgresDatabase(const PostgresDatabase&) = delete;
  PostgresDatabase& operator=(const PostgresDatabase&) = delete;

  std::string name() const override { return address_.shown; }
  std::unique_ptr<SqlCursor> prepare(std::string_view sql) override;
  void run(const std::string& sql) override;
  void begin() override;
  void commit() override;
  void rollback() noexcept override;
  const char* locking() const override { return " FOR UPDATE"; }
  const char* locking_free_ones() const override { return " FOR UPDATE SKIP LOCKED"; }
  /// The server's time, asked at each transaction's beginning and counted on from there.
  JobTime now() const override;
  int schema_version() override;
  void set_schema_version(int version) override;
  void lock_schema() override;

 private:
  class Cursor;
  struct Session;
  struct Rows;

  void connect();
  // The open transaction is gone with its connection.
  [[noreturn]] void throw_lost() const;
  // Calls `work` with the session, which is made where there is none. A lost connection is made
  // anew and `work` repeated once where no transaction is open.
  template <typename Work>
  auto with_session(const Work& work);
  Rows execute(const std::string& sql, const std::vector<std::string>& values);
  void note_time(std::int64_t milliseconds);
  // What became of the transaction whose commit was not answered: true, it was kept.
  bool was_kept();

  const PostgresAddress address_;
  std::unique_ptr<Session> session_;  // null: lost
  bool was_connected_ = false;
  bool in_transaction_ = false;
  std::string transaction_;               // the server's number of the open one
  std::atomic<std::int64_t> offset_ = 0;  // ms; the server's time less our steady clock's
};

}  // namespace regarment
