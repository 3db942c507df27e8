#include "jobs/sql_database.h"

#include "base/error.h"

namespace regarment {
namespace {

constexpr std::size_t kLongestText = std::size_t{1} << 20U;

}  // namespace

std::int64_t SqlDatabase::number(std::string_view sql) {
  SqlStatement statement(*this, sql);
  return statement.step() ? statement.integer(0) : 0;
}

void SqlStatement::bind(std::string_view value) {
  if (value.size() > kLongestText) throw InvalidInput("job store: a text longer than 1 MiB");
  cursor_->bind_text(value);
}

void SqlStatement::run() {
  while (step()) {
  }
}

}  // namespace regarment
