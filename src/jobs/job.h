#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace regarment {

/// A moment, UTC, to the millisecond.
using JobTime = std::chrono::sys_time<std::chrono::milliseconds>;

/// What tells the time; tests give one they can move. Any thread may call it.
using JobClock = std::function<JobTime()>;

/// The system's own clock.
JobTime system_time();

/// "2026-03-01T12:30:05.250Z".
std::string rfc3339(JobTime time);

/// Queued and Running jobs go on; the others have ended and stay as they are, but for `Dead`, which
/// an administrator may queue again. Failed: the scan or the request is at fault. Dead: every
/// attempt crashed, was killed, or ran out of something.
enum class JobState { Queued, Running, Succeeded, Failed, Cancelled, Dead };
constexpr std::array kJobStates = {JobState::Queued, JobState::Running,   JobState::Succeeded,
                                   JobState::Failed, JobState::Cancelled, JobState::Dead};
/// "queued", "running", ...
std::string_view name_of(JobState state);
std::optional<JobState> job_state_named(std::string_view name);
/// Whether nothing more happens to a job of this state by itself.
bool has_ended(JobState state);

/// What a job runs: the command of the program of the same name.
///   fit       the scan of its folder
///   refit     the result of the job `source`, with other options
///   render    pictures of the scan from four sides
///   evaluate  the table `truth.csv` of its folder with the scans beside it; of a batch: its
///             finished fits as they are (batch_tables.h)
enum class JobKind { Fit, Refit, Render, Evaluate };
std::string_view name_of(JobKind kind);
std::optional<JobKind> job_kind_named(std::string_view name);

/// Why a job failed, died or is tried again: a code for programs (see worker.h) and one line for
/// people.
struct JobError {
  std::string code;
  std::string message;
};

/// What a person decided about a result.
enum class Verdict { Accepted, Rejected, Unsure };
std::string_view name_of(Verdict verdict);
std::optional<Verdict> verdict_named(std::string_view name);

struct Review {
  Verdict verdict = Verdict::Unsure;
  std::string note;  // for people, may be empty
  std::string by;    // id of an API key; empty where none is needed
  JobTime time;
};

/// One request, as the store knows it. Its files lie in its folder (job_folder.h).
struct Job {
  std::string id;  // new_job_id()
  JobKind kind = JobKind::Fit;
  JobState state = JobState::Queued;
  std::string owner;                  // id of an API key; empty where none is needed
  std::string batch;                  // id of a batch; empty: none
  std::string source;                 // of a refit: the job whose result it begins from
  std::string name;                   // the scan as its sender calls it; personal, never logged
  std::vector<std::string> garments;  // template names, outermost first
  std::string options = "{}";         // a JSON object: job_options.h
  JobTime created;
  std::optional<JobTime> started;  // of the last attempt
  std::optional<JobTime> ended;
  double progress = 0;         // 0 to 1, over the whole job
  std::string stage;           // "measure"; empty before the first
  int attempts = 0;            // begun and not handed back
  std::int64_t token = 0;      // of the last claim; of a succeeded job: names its result folder
  std::string worker;          // who has it, or had it last
  bool cancel_wanted = false;  // asked for while running
  std::optional<JobError> error;
  std::optional<Review> review;
  std::uint64_t bytes = 0;  // its folder takes on disk, as last told

  /// Whether a worker has it under this token.
  bool is_held_under(std::int64_t claim) const {
    return state == JobState::Running && token == claim;
  }
};

/// Something that happened to a job. Numbers rise by one from 1 in each job.
struct JobEvent {
  std::int64_t number = 0;
  JobTime time;
  std::string kind;  // "state", "progress" or "review"
  // A JSON object: {"state", "attempt", "error"?: {"code", "message"}}; {"progress", "stage",
  // "detail"?}; {"verdict", "note", "by"}, where "verdict" is null when
  // one was taken back.
  std::string data;
};

/// Jobs that belong together, with how many are in each state (in the order of kJobStates).
struct Batch {
  std::string id, name, owner;
  JobTime created;
  std::array<std::uint64_t, kJobStates.size()> jobs{};
};

/// Twice as many random hexadecimal digits as `bytes`, at most 64. Throws TemporaryError when the
/// system has no randomness to give.
std::string random_hex(std::size_t bytes);
/// 24 random hexadecimal digits, fit for a file name and an address.
std::string new_job_id();
/// Whether `text` has the form of one.
bool is_job_id(std::string_view text);

}  // namespace regarment
