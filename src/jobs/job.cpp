#include "jobs/job.h"

#include <sys/random.h>

#include <algorithm>
#include <cstdio>

#include "base/error.h"

namespace regarment {
namespace {

constexpr std::array<std::string_view, kJobStates.size()> kStateNames = {
    "queued", "running", "succeeded", "failed", "cancelled", "dead"};
constexpr std::array<std::string_view, 4> kKindNames = {"fit", "refit", "render", "evaluate"};
constexpr std::array<std::string_view, 3> kVerdictNames = {"accepted", "rejected", "unsure"};
constexpr std::size_t kIdBytes = 12;

// The enumerator whose name this is: names stand in the order of the enumerators.
template <typename Enum, std::size_t kCount>
std::optional<Enum> named(std::string_view name,
                          const std::array<std::string_view, kCount>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace

JobTime system_time() {
  return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

std::string rfc3339(JobTime time) {
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(time - day);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ",
                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()), static_cast<int>(clock.hours().count()),
                static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()),
                static_cast<int>(clock.subseconds().count()));
  return text.data();
}

std::string_view name_of(JobState state) { return kStateNames[static_cast<std::size_t>(state)]; }

std::optional<JobState> job_state_named(std::string_view name) {
  return named<JobState>(name, kStateNames);
}

bool has_ended(JobState state) { return state != JobState::Queued && state != JobState::Running; }

std::string_view name_of(JobKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::optional<JobKind> job_kind_named(std::string_view name) {
  return named<JobKind>(name, kKindNames);
}

std::string_view name_of(Verdict verdict) {
  return kVerdictNames[static_cast<std::size_t>(verdict)];
}

std::optional<Verdict> verdict_named(std::string_view name) {
  return named<Verdict>(name, kVerdictNames);
}

std::string random_hex(std::size_t bytes) {
  std::array<unsigned char, 64> random{};
  if (bytes > random.size()) throw InvalidInput("random_hex: more than 64 bytes");
  if (::getrandom(random.data(), bytes, 0) != static_cast<ssize_t>(bytes)) {
    throw TemporaryError("the system gives no random numbers; try again later");
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i) {
    text += kDigits[random[i] >> 4U];
    text += kDigits[random[i] & 15U];
  }
  return text;
}

std::string new_job_id() { return random_hex(kIdBytes); }

bool is_job_id(std::string_view text) {
  return text.size() == 2 * kIdBytes &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace regarment
