#include "jobs/sql_rows.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

// Bytes that are not UTF-8 may stand in a message; they are replaced here, and nothing is lost
// where the text itself is kept.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<JobTime> time_or_none(const SqlStatement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return time_of(row.integer(column));
}

std::vector<std::string> garments_of(const std::string& text) {
  std::vector<std::string> garments;
  for (const auto& one : Json::parse(text)) garments.push_back(one.get<std::string>());
  return garments;
}

}  // namespace

const char* const kJobColumns =
    "id, kind, state, owner, batch, source, name, garments, options, created, started, ended, "
    "progress, stage, attempts, token, worker, cancel_wanted, error_code, error_message, bytes, "
    "verdict, note, reviewer, reviewed ";

Job job_of_row(const SqlStatement& row) {
  Job job;
  int column = 0;
  job.id = row.text(column++);
  job.kind = job_kind_named(row.text(column++)).value_or(JobKind::Fit);
  job.state = job_state_named(row.text(column++)).value_or(JobState::Dead);
  for (std::string* text : {&job.owner, &job.batch, &job.source, &job.name}) {
    *text = row.text(column++);
  }
  job.garments = garments_of(row.text(column++));
  job.options = row.text(column++);
  job.created = time_of(row.integer(column++));
  job.started = time_or_none(row, column++);
  job.ended = time_or_none(row, column++);
  job.progress = row.real(column++);
  job.stage = row.text(column++);
  job.attempts = static_cast<int>(row.integer(column++));
  job.token = row.integer(column++);
  job.worker = row.text(column++);
  job.cancel_wanted = row.integer(column++) != 0;
  JobError error{row.text(column), row.text(column + 1)};
  if (!error.code.empty()) job.error = error;
  column += 2;
  job.bytes = static_cast<std::uint64_t>(row.integer(column++));
  if (const auto verdict = verdict_named(row.text(column))) {
    job.review = {*verdict, row.text(column + 1), row.text(column + 2),
                  time_of(row.integer(column + 3))};
  }
  return job;
}

StoredKey key_of_row(const SqlStatement& row) {
  StoredKey out;
  out.key.id = row.text(0);
  out.key.name = row.text(1);
  std::istringstream scopes(row.text(2));
  for (std::string name; scopes >> name;) {
    if (const auto scope = scope_named(name)) out.key.scopes.push_back(*scope);
  }
  out.hash = row.text(3);
  out.key.created = time_of(row.integer(4));
  out.key.revoked = time_or_none(row, 5);
  return out;
}

std::string scopes_text(const std::vector<Scope>& scopes) {
  std::string text;
  for (const Scope scope : scopes) {
    text.append(text.empty() ? "" : " ").append(name_of(scope));
  }
  return text;
}

JobTime time_of(std::int64_t milliseconds) {
  return JobTime(std::chrono::milliseconds(milliseconds));
}

std::string garments_json(const std::vector<std::string>& garments) { return dump(Json(garments)); }

std::string state_event(JobState state, int attempt, const JobError& error) {
  Json json = {{"state", name_of(state)}, {"attempt", attempt}};
  if (!error.code.empty()) json["error"] = {{"code", error.code}, {"message", error.message}};
  return dump(json);
}

std::string progress_event(double fraction, const std::string& stage, const std::string& detail) {
  Json json = {{"progress", fraction}, {"stage", stage}};
  if (!detail.empty()) json["detail"] = detail;
  return dump(json);
}

std::string review_event(const Review& review) {
  return dump({{"verdict", name_of(review.verdict)}, {"note", review.note}, {"by", review.by}});
}

std::string taken_back_event(std::string_view by) {
  return dump({{"verdict", nullptr}, {"note", ""}, {"by", by}});
}

}  // namespace regarment
