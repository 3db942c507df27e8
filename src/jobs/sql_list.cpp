// Lists of jobs: filters become conditions with values, never text of the caller in SQL.

#include <algorithm>
#include <charconv>
#include <variant>

#include "base/error.h"
#include "jobs/sql_rows.h"
#include "jobs/sql_store.h"

namespace regarment {
namespace {

constexpr int kMostListed = 500;

/// Conditions that all hold, and the values of their "?".
struct Conditions {
  std::string sql = "1 = 1";
  std::vector<std::variant<std::int64_t, std::string>> values;

  template <typename... Values>
  void add(const std::string& condition, const Values&... of_it) {
    sql += " AND (" + condition + ")";
    (values.emplace_back(of_it), ...);
  }
};

// A text that LIKE finds as it is, in small ASCII letters.
std::string part_of(const std::string& text) {
  std::string pattern = "%";
  for (const char c : text) {
    if (c == '%' || c == '_' || c == '\\') pattern += '\\';
    pattern += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return pattern + "%";
}

std::int64_t cursor_of(const std::string& text) {
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || number < 0) {
    throw UsageError("after: no mark of a list; take the 'next' of the page before");
  }
  return number;
}

void add_states(const std::vector<JobState>& states, Conditions& where) {
  if (states.empty()) return;
  std::string places;
  for (const JobState state : states) {
    places += places.empty() ? "?" : ", ?";
    where.values.emplace_back(std::string(name_of(state)));
  }
  where.sql += " AND state IN (" + places + ")";
}

Conditions conditions_of(const JobFilter& filter) {
  Conditions where;
  add_states(filter.states, where);
  if (!filter.text.empty()) {
    const std::string pattern = part_of(filter.text);
    where.add(R"(lower(name) LIKE ? ESCAPE '\' OR id LIKE ? ESCAPE '\' OR )"
              R"(lower(garments) LIKE ? ESCAPE '\')",
              pattern, pattern, pattern);
  }
  if (!filter.batch.empty()) where.add("batch = ? AND batch <> ''", filter.batch);
  if (!filter.owner.empty()) where.add("owner = ?", filter.owner);
  if (!filter.source.empty()) where.add("source = ?", filter.source);
  if (filter.kind) where.add("kind = ?", std::string(name_of(*filter.kind)));
  if (filter.verdict) where.add("verdict = ?", std::string(name_of(*filter.verdict)));
  if (filter.reviewed) where.add(*filter.reviewed ? "verdict <> ''" : "verdict = ''");
  if (!filter.after.empty()) where.add("number < ?", cursor_of(filter.after));
  return where;
}

}  // namespace

JobPage SqlJobStore::list(const JobFilter& filter) {
  if (filter.limit < 1 || filter.limit > kMostListed) {
    throw UsageError("limit: " + std::to_string(filter.limit) + " is not from 1 to 500");
  }
  const Conditions where = conditions_of(filter);
  const std::lock_guard<std::mutex> lock(read_mutex_);
  SqlStatement row(*reader_, std::string("SELECT ") + kJobColumns + ", number FROM jobs WHERE " +
                                 where.sql + " ORDER BY number DESC LIMIT ?");
  for (const auto& value : where.values) {
    std::visit([&](const auto& one) { row.bind(one); }, value);
  }
  row.bind(filter.limit + 1);        // one more tells whether there is a next page
  constexpr int kNumberColumn = 25;  // after kJobColumns
  JobPage page;
  while (row.step()) {
    if (page.jobs.size() == static_cast<std::size_t>(filter.limit)) {
      page.next = std::to_string(row.integer(kNumberColumn) + 1);
      break;
    }
    page.jobs.push_back(job_of_row(row));
  }
  return page;
}

}  // namespace regarment
