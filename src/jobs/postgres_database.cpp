#include "jobs/postgres_database.h"

#include <libpq-fe.h>

#include <charconv>
#include <map>
#include <optional>
#include <pqxx/pqxx>
#include <thread>

#include "base/away_error.h"
#include "base/one_line.h"
#include "jobs/postgres_text.h"

namespace regarment {
namespace {

using Steady = std::chrono::steady_clock;

constexpr int kOldestServer = 130000;  // pg_current_xact_id
constexpr std::chrono::seconds kDoubt{10};
constexpr std::chrono::milliseconds kDoubtPause{100};

// Whatever the server's own settings are: every commit is on its disk, and nobody waits for ever.
constexpr const char* kSettings =
    "SET search_path = regarment; SET synchronous_commit = on; SET lock_timeout = '10s'; "
    "SET statement_timeout = '60s'; SET idle_in_transaction_session_timeout = '60s'; "
    "SET default_transaction_isolation = 'read committed'; SET standard_conforming_strings = on; ";
constexpr const char* kTime = "(extract(epoch FROM clock_timestamp()) * 1000)::bigint";

std::int64_t steady_milliseconds() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(Steady::now().time_since_epoch())
      .count();
}

template <typename Number>
Number number_of(const char* text) {
  Number number{};
  std::from_chars(text, text + std::char_traits<char>::length(text), number);
  return number;
}

// The library's first line says what is wrong.
std::string said(const std::string& shown, const std::exception& error) {
  const std::string_view all = error.what();
  return shown + ": job store: " + one_line(all.substr(0, all.find('\n')), 300);
}

[[noreturn]] void throw_away(const std::string& shown, const std::exception& error) {
  throw AwayError(said(shown, error) + "; try again later");
}

// A server that lets nobody in just now: full, starting, stopping or recovering.
bool is_passing(const std::exception& error) {
  const std::string_view why = error.what();
  for (const char* sign : {"too many", "connection slots", "not yet accepting", "starting up",
                           "shutting down", "recovery"}) {
    if (why.find(sign) != std::string_view::npos) return true;
  }
  return false;
}

// What the server answered, as an error of ours.
[[noreturn]] void throw_refusal(const std::string& shown, const pqxx::sql_error& error) {
  const std::string& state = error.sqlstate();
  const std::string message = said(shown, error);
  if (state == "53100") throw TemporaryError(message + "; free some of the server's disk");
  if (state == "42501") throw UsageError(message + "; grant the user CREATE on the database");
  if (state.starts_with("XX")) throw ReadError(message + "; see the server's log");
  // Resources, locks, conflicts, interventions, its system; a server that only reads.
  for (const char* passing : {"53", "55", "40", "57", "58", "25"}) {
    if (state.starts_with(passing)) throw AwayError(message + "; try again later");
  }
  throw InvalidInput(message);
}

}  // namespace

struct PostgresDatabase::Session {
  explicit Session(const std::string& where) : connection(where), quiet(connection) {}

  pqxx::connection connection;
  pqxx::quiet_errorhandler quiet;               // what the library says, its exceptions say too
  pqxx::nontransaction work{connection};        // ours are begun and ended by hand
  std::map<std::string, std::string> prepared;  // name of each statement
};

struct PostgresDatabase::Rows {
  pqxx::result result;
};

class PostgresDatabase::Cursor : public SqlCursor {
 public:
  Cursor(PostgresDatabase& database, std::string_view sql) : database_(database), sql_(sql) {}

  void bind_integer(std::int64_t value) override { values_.push_back(std::to_string(value)); }
  void bind_real(double value) override {
    std::array<char, 40> text{};
    char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    values_.emplace_back(text.data(), end);
  }
  void bind_text(std::string_view value) override { values_.push_back(postgres_text(value)); }
  bool step() override {
    if (!rows_) {
      rows_ = database_.execute(sql_, values_);
    } else {
      ++at_;
    }
    return at_ < rows_->result.size();
  }
  std::int64_t integer(int column) const override {
    return number_of<std::int64_t>(field(column).c_str());
  }
  double real(int column) const override { return number_of<double>(field(column).c_str()); }
  std::string text(int column) const override {
    return bytes_of_postgres_text({field(column).c_str(), field(column).size()});
  }
  bool is_null(int column) const override { return field(column).is_null(); }

 private:
  pqxx::field field(int column) const { return rows_->result[at_][column]; }

  PostgresDatabase& database_;
  std::string sql_;
  std::vector<std::string> values_;
  std::optional<Rows> rows_;
  pqxx::result::size_type at_ = 0;
};

PostgresDatabase::PostgresDatabase(PostgresAddress address) : address_(std::move(address)) {
  connect();
  was_connected_ = true;
}

PostgresDatabase::~PostgresDatabase() { rollback(); }

void PostgresDatabase::connect() {
  try {
    auto session = std::make_unique<Session>(address_.connection);
    if (session->connection.server_version() < kOldestServer) {
      throw UsageError(address_.shown +
                       ": the server is older than PostgreSQL 13; use a newer one");
    }
    const auto facts = session->work.exec(
        kSettings + std::string("SELECT current_setting('server_encoding'), ") + kTime);
    const std::string encoding = facts[0][0].c_str();
    if (encoding != "UTF8" && encoding != "SQL_ASCII") {
      throw UsageError(address_.shown + ": a database of the encoding " + one_line(encoding, 40) +
                       "; make one with UTF8");
    }
    note_time(number_of<std::int64_t>(facts[0][1].c_str()));
    session_ = std::move(session);
  } catch (const pqxx::failure& error) {
    // A server that answers but does not let us in will not do so by itself.
    const bool answers = PQping(address_.connection.c_str()) == PQPING_OK;
    if (was_connected_ || is_passing(error) || !answers) throw_away(address_.shown, error);
    throw UsageError(said(address_.shown, error) + "; correct --store, or the database's rights");
  }
}

void PostgresDatabase::throw_lost() const {
  throw AwayError(address_.shown + ": job store: the connection is lost; try again");
}

template <typename Work>
auto PostgresDatabase::with_session(const Work& work) {
  for (bool again = !in_transaction_;; again = false) {
    if (!session_) in_transaction_ ? throw_lost() : connect();
    try {
      return work(*session_);
    } catch (const pqxx::failure& error) {
      const auto* refusal = dynamic_cast<const pqxx::sql_error*>(&error);
      if (refusal != nullptr && session_->connection.is_open()) {
        throw_refusal(address_.shown, *refusal);
      }
      session_.reset();
      if (!again) throw_away(address_.shown, error);
    }
  }
}

PostgresDatabase::Rows PostgresDatabase::execute(const std::string& sql,
                                                 const std::vector<std::string>& values) {
  return with_session([&](Session& session) {
    auto [known, added] = session.prepared.try_emplace(sql);
    if (added) {
      known->second = "s" + std::to_string(session.prepared.size());
      session.connection.prepare(known->second, postgres_statement(sql));
    }
    return Rows{
        session.work.exec_prepared(known->second, pqxx::prepare::make_dynamic_params(values))};
  });
}

std::unique_ptr<SqlCursor> PostgresDatabase::prepare(std::string_view sql) {
  return std::make_unique<Cursor>(*this, sql);
}

void PostgresDatabase::run(const std::string& sql) {
  with_session([&](Session& session) { session.work.exec(postgres_tables(sql)); });
}

void PostgresDatabase::begin() {
  try {
    with_session([&](Session& session) {
      const auto facts =
          session.work.exec(std::string("BEGIN; SELECT pg_current_xact_id()::text, ") + kTime);
      transaction_ = facts[0][0].c_str();
      note_time(number_of<std::int64_t>(facts[0][1].c_str()));
    });
    in_transaction_ = true;
  } catch (...) {
    in_transaction_ = session_ != nullptr;
    rollback();
    throw;
  }
}

void PostgresDatabase::commit() {
  if (!session_) throw_lost();
  in_transaction_ = false;
  try {
    session_->work.exec("COMMIT");
  } catch (const pqxx::failure& error) {
    const auto* refusal = dynamic_cast<const pqxx::sql_error*>(&error);
    if (refusal != nullptr && session_->connection.is_open()) {
      throw_refusal(address_.shown, *refusal);
    }
    session_.reset();
    if (!was_kept()) throw_away(address_.shown, error);
  }
}

bool PostgresDatabase::was_kept() {
  const auto patience = Steady::now() + kDoubt;
  for (;;) {
    try {
      const std::string end =
          execute("SELECT pg_xact_status(?::xid8)", {transaction_}).result[0][0].c_str();
      if (end == "committed") return true;
      if (end == "aborted") return false;
    } catch (const TemporaryError&) {
      // It may be back in a moment.
    }
    if (Steady::now() >= patience) {
      throw AwayError(address_.shown +
                      ": job store: the connection broke during a change, and whether it was "
                      "kept cannot be asked; look before you try again");
    }
    std::this_thread::sleep_for(kDoubtPause);
  }
}

void PostgresDatabase::rollback() noexcept {
  if (!in_transaction_) return;
  in_transaction_ = false;
  if (!session_) return;
  try {
    session_->work.exec("ROLLBACK");
  } catch (const std::exception&) {
    session_.reset();  // the server ends the transaction of a connection that is gone
  }
}

JobTime PostgresDatabase::now() const {
  return JobTime(std::chrono::milliseconds(offset_ + steady_milliseconds()));
}

void PostgresDatabase::note_time(std::int64_t milliseconds) {
  offset_ = milliseconds - steady_milliseconds();
}

// One statement, and so one moment: somebody may be making the tables just now.
int PostgresDatabase::schema_version() {
  SqlStatement row(*this,
                   "SELECT count(*), sum((relname = 'schema_version')::int) FROM pg_class "
                   "JOIN pg_namespace ON pg_namespace.oid = relnamespace "
                   "WHERE nspname = 'regarment'");
  row.step();
  if (row.integer(0) == 0) return 0;
  if (row.integer(1) == 0) {
    throw UsageError(address_.shown +
                     ": its schema 'regarment' belongs to another program; name another database");
  }
  return static_cast<int>(number("SELECT version FROM schema_version"));
}

void PostgresDatabase::set_schema_version(int version) {
  run("CREATE TABLE IF NOT EXISTS schema_version (version INTEGER NOT NULL); "
      "DELETE FROM schema_version; INSERT INTO schema_version VALUES (" +
      std::to_string(version) + ")");
}

void PostgresDatabase::lock_schema() {
  constexpr const char* kNumber = "1380405588";  // "RGMT"
  number(std::string("SELECT count(*) FROM (SELECT pg_advisory_xact_lock(") + kNumber +
         ")) AS held");
  if (number("SELECT count(*) FROM pg_namespace WHERE nspname = 'regarment'") == 0) {
    run("CREATE SCHEMA regarment");
  }
}

}  // namespace regarment
