#include "jobs/sqlite_database.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/away_error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr int kBusyMilliseconds = 10000;
constexpr std::int64_t kApplication = 0x52474d54;  // "RGMT"

std::string shown(const fs::path& file) { return one_line(file.string(), 300); }

// SQLite would make the file readable to everybody; its side files take the rights of this one. One
// that is there is not opened here: closing it would drop the locks that other connections of this
// process hold on it, and another process would take the log from under them.
void make_file(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  const int made = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  int why = errno;
  if (made >= 0) {
    ::close(made);
    return;
  }
  struct stat facts {};
  const bool there = why == EEXIST && ::stat(file.c_str(), &facts) == 0;
  if (there && S_ISREG(facts.st_mode)) {
    if (::access(file.c_str(), R_OK | W_OK) == 0) return;
    why = errno;
  }
  const std::string end =
      there && !S_ISREG(facts.st_mode) ? "it is no regular file" : std::strerror(why);
  const std::string message = shown(file) + ": the job store cannot be opened (" + end + ")";
  if (why == ENOSPC || why == EDQUOT || why == EMFILE || why == ENFILE) {
    throw TemporaryError(message + "; free some and try again");
  }
  throw UsageError(message + "; name another --store, or another --data");
}

/// Finalised with its statement, so that no lock is left behind.
class SqliteCursor : public SqlCursor {
 public:
  SqliteCursor(const SqliteDatabase& database, sqlite3* handle, std::string_view sql)
      : database_(database) {
    database_.check(
        sqlite3_prepare_v2(handle, sql.data(), static_cast<int>(sql.size()), &statement_, nullptr));
  }
  ~SqliteCursor() override { sqlite3_finalize(statement_); }
  SqliteCursor(const SqliteCursor&) = delete;
  SqliteCursor& operator=(const SqliteCursor&) = delete;

  void bind_integer(std::int64_t value) override {
    database_.check(sqlite3_bind_int64(statement_, ++bound_, value));
  }
  void bind_real(double value) override {
    database_.check(sqlite3_bind_double(statement_, ++bound_, value));
  }
  void bind_text(std::string_view value) override {
    database_.check(sqlite3_bind_text(statement_, ++bound_, value.empty() ? "" : value.data(),
                                      static_cast<int>(value.size()), SQLITE_TRANSIENT));
  }
  bool step() override {
    const int code = sqlite3_step(statement_);
    database_.check(code);
    return code == SQLITE_ROW;
  }
  std::int64_t integer(int column) const override {
    return sqlite3_column_int64(statement_, column);
  }
  double real(int column) const override { return sqlite3_column_double(statement_, column); }
  std::string text(int column) const override {
    const void* bytes = sqlite3_column_blob(statement_, column);
    const int size = sqlite3_column_bytes(statement_, column);
    return bytes == nullptr
               ? std::string()
               : std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  }
  bool is_null(int column) const override {
    return sqlite3_column_type(statement_, column) == SQLITE_NULL;
  }

 private:
  const SqliteDatabase& database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

}  // namespace

SqliteDatabase::SqliteDatabase(const fs::path& file) : file_(file) {
  make_file(file_);
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX;
  try {
    check(sqlite3_open_v2(file_.c_str(), &handle_, flags, nullptr));
    sqlite3_extended_result_codes(handle_, 1);
    sqlite3_busy_timeout(handle_, kBusyMilliseconds);
    // Reads the file's head, and so tells whether it is a database at all.
    number("PRAGMA schema_version");
    run("PRAGMA synchronous=FULL; PRAGMA foreign_keys=ON; PRAGMA secure_delete=ON");
  } catch (...) {
    sqlite3_close(handle_);
    throw;
  }
}

SqliteDatabase::~SqliteDatabase() { sqlite3_close(handle_); }

// Two processes that open a new file at once get in each other's way here, and SQLite does not wait
// by itself.
void SqliteDatabase::share() {
  constexpr int kTries = 200, kPauseMilliseconds = 20;
  for (int tries = 1;; ++tries) {
    try {
      SqlStatement mode(*this, "PRAGMA journal_mode=WAL");
      if (mode.step() && mode.text(0) == "wal") return;
    } catch (const TemporaryError&) {
      if (tries == kTries) throw;
    }
    if (tries == kTries) {
      throw UsageError(shown(file_) +
                       ": this file system cannot share a job store (no WAL); put it on a local "
                       "disk, or use PostgreSQL");
    }
    sqlite3_sleep(kPauseMilliseconds);
  }
}

void SqliteDatabase::wipe_deleted() {
  // Where somebody reads, the next one does it.
  sqlite3_busy_timeout(handle_, 0);
  sqlite3_wal_checkpoint_v2(handle_, nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
  sqlite3_busy_timeout(handle_, kBusyMilliseconds);
}

void SqliteDatabase::check(int code) const {
  if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return;
  const std::string why = handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
  const std::string message = shown(file_) + ": job store: " + one_line(why, 200);
  switch (code & 0xff) {
    case SQLITE_FULL:
      throw TemporaryError(message + "; free some disk and try again");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw AwayError(message + "; try again later");
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
    case SQLITE_NOMEM:
    case SQLITE_PROTOCOL:
      throw TemporaryError(message + "; try again later");
    case SQLITE_READONLY:
    case SQLITE_PERM:
      throw UsageError(message + "; make the file and its folder writable");
    case SQLITE_NOTADB:
      throw UsageError(message + "; name another --store");
    case SQLITE_CORRUPT:
      throw ReadError(message + "; the file is damaged: put a backup in its place");
    default:
      throw InvalidInput(message);
  }
}

std::string SqliteDatabase::name() const { return shown(file_); }

std::unique_ptr<SqlCursor> SqliteDatabase::prepare(std::string_view sql) {
  return std::make_unique<SqliteCursor>(*this, handle_, sql);
}

void SqliteDatabase::run(const std::string& sql) {
  check(sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr));
}

void SqliteDatabase::rollback() noexcept {
  // Some failures end a transaction by themselves; a rollback that fails leaves nothing either.
  if (sqlite3_get_autocommit(handle_) == 0) {
    sqlite3_exec(handle_, "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

// An empty file is nobody's yet.
int SqliteDatabase::schema_version() {
  const std::int64_t version = number("PRAGMA user_version");
  const bool ours = number("PRAGMA application_id") == kApplication ||
                    (version == 0 && number("SELECT count(*) FROM sqlite_master") == 0);
  if (!ours) {
    throw UsageError(shown(file_) + ": an SQLite file of another program; name another --store");
  }
  return static_cast<int>(version);
}

void SqliteDatabase::set_schema_version(int version) {
  run("PRAGMA application_id=" + std::to_string(kApplication));
  run("PRAGMA user_version=" + std::to_string(version));
}

}  // namespace regarment
