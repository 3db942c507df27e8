#pragma once

#include <string>
#include <string_view>

namespace regarment {

/// Whether a store's place is meant for PostgreSQL: "postgresql://..." or "postgres://...".
bool is_postgres_address(std::string_view where);

/// Where a PostgreSQL database is and how to reach it.
struct PostgresAddress {
  std::string connection;  // for the library; may hold a password
  std::string shown;       // "postgresql://user@host:5432/name", for people; holds no secret

  /// What the address leaves out comes from the environment (PGPASSWORD and the like) and the
  /// user's password file, as for every client of PostgreSQL; connecting takes ten seconds at most
  /// unless it says otherwise. Throws UsageError, which repeats nothing of it, when it is none.
  static PostgresAddress parse(const std::string& text);
};

}  // namespace regarment
