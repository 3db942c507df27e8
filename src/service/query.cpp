#include "service/query.h"

#include <charconv>

#include "base/one_line.h"
#include "http/problem.h"

namespace regarment {
namespace {

constexpr int kMostJobs = 500;

[[noreturn]] void refuse(const std::string& name, const std::string& wanted) {
  throw HttpProblem(400, "bad_parameter", one_line(name, 60) + ": " + wanted);
}

std::vector<JobState> states_of(const std::string& text) {
  std::vector<JobState> out;
  for (const std::string_view name : list_members(text)) {
    const std::optional<JobState> state = job_state_named(name);
    if (!state)
      refuse("state", "give queued, running, succeeded, failed, cancelled or dead, with commas");
    out.push_back(*state);
  }
  return out;
}

int limit_of(const std::string& text) {
  int limit = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), limit);
  if (error != std::errc() || end != text.data() + text.size() || limit < 1 || limit > kMostJobs)
    refuse("limit", "give a number from 1 to 500");
  return limit;
}

bool truth_of(const std::string& name, const std::string& text) {
  if (text != "true" && text != "false") refuse(name, "give true or false");
  return text == "true";
}

template <class T>
T found(const std::string& name, std::optional<T> value, const char* wanted) {
  if (!value) refuse(name, wanted);
  return *value;
}

}  // namespace

JobFilter read_filter(const Request& request) {
  JobFilter out;
  for (const auto& [name, value] : request.query) {
    if (name == "state")
      out.states = states_of(value);
    else if (name == "text")
      out.text = value;
    else if (name == "batch")
      out.batch = value;
    else if (name == "source")
      out.source = value;
    else if (name == "kind")
      out.kind = found(name, job_kind_named(value), "give fit, refit, render or evaluate");
    else if (name == "verdict")
      out.verdict = found(name, verdict_named(value), "give accepted, rejected or unsure");
    else if (name == "reviewed")
      out.reviewed = truth_of(name, value);
    else if (name == "limit")
      out.limit = limit_of(value);
    else if (name == "after")
      out.after = value;
    else
      refuse(name,
             "no parameter of this list; use state, text, batch, source, kind, verdict, "
             "reviewed, limit or after");
  }
  return out;
}

}  // namespace regarment
