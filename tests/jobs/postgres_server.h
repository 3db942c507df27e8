#pragma once

#include <memory>
#include <string>

#include "base/child_process.h"
#include "support/folders.h"

namespace regarment {

/// A PostgreSQL server of our own, in a temporary folder and reached by a socket in it only. It
/// ends with this, and with the process should that be killed.
class PostgresServer {
 public:
  /// Whether Debian's postgresql-15 is there.
  static bool is_installed();

  /// `durable`: what is committed outlives the machine as well, not only the server. Throws
  /// TemporaryError when the server does not come up.
  explicit PostgresServer(bool durable = false);
  ~PostgresServer();
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  /// Of one of its databases, for --store.
  std::string address(const std::string& database) const;
  std::filesystem::path socket_folder() const { return folder_.path(); }
  /// Runs SQL in a database, outside a transaction.
  void run(const std::string& database, const std::string& sql) const;
  /// Makes an empty database, with these words of CREATE DATABASE; its address.
  std::string make_database(const std::string& words = "");

  /// All its processes end at once, as when the power fails.
  void kill();
  void start();

 private:
  std::filesystem::path data() const { return folder_.path() / "data"; }

  TemporaryFolder folder_;
  bool durable_;
  std::unique_ptr<ChildProcess> server_;
  int databases_ = 0;
};

}  // namespace regarment
