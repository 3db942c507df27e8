#include "jobs/postgres_address.h"

#include <libpq-fe.h>

#include <array>
#include <map>
#include <memory>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

// For what an address may leave out. A connection whose other end is gone is given up after half a
// minute, not after the system's hours.
constexpr std::array<std::pair<const char*, const char*>, 4> kDefaults = {{
    {"connect_timeout", "10"},
    {"application_name", "regarment"},
    {"keepalives_idle", "30"},
    {"tcp_user_timeout", "30000"},
}};

using Fields = std::map<std::string, std::string>;

// The fields an address sets.
Fields fields_of(const std::string& text) {
  char* why = nullptr;
  const std::unique_ptr<PQconninfoOption, decltype(&PQconninfoFree)> options(
      PQconninfoParse(text.c_str(), &why), &PQconninfoFree);
  PQfreemem(why);  // it repeats the address, password and all
  if (!options) {
    throw UsageError(
        "--store: this is no address of a PostgreSQL database; it looks like "
        "postgresql://user@host:5432/name");
  }
  Fields fields;
  for (const PQconninfoOption* one = options.get(); one->keyword != nullptr; ++one) {
    if (one->val != nullptr) fields[one->keyword] = one->val;
  }
  return fields;
}

std::string quoted(const std::string& value) {
  std::string out = "'";
  for (const char c : value) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

std::string shown_fields(Fields fields) {
  const std::string user = fields["user"], port = fields["port"];
  std::string out = "postgresql://" + user + (user.empty() ? "" : "@") + fields["host"] +
                    (port.empty() ? "" : ":" + port) + "/" + fields["dbname"];
  return one_line(out, 200);
}

}  // namespace

bool is_postgres_address(std::string_view where) {
  return where.starts_with("postgresql://") || where.starts_with("postgres://");
}

PostgresAddress PostgresAddress::parse(const std::string& text) {
  Fields fields = fields_of(text);
  PostgresAddress out;
  out.shown = shown_fields(fields);
  for (const auto& [name, value] : kDefaults) fields.emplace(name, value);
  fields["client_encoding"] = "UTF8";
  for (const auto& [name, value] : fields) out.connection += name + "=" + quoted(value) + " ";
  return out;
}

}  // namespace regarment
