#include "jobs/attempt.h"

#include <signal.h>

#include <algorithm>
#include <cstring>
#include <thread>

#include "base/error.h"
#include "base/one_line.h"
#include "jobs/job_command.h"

namespace regarment {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kLook{100};        // between two looks at the child
constexpr milliseconds kTellEvery{500};   // between two notes of progress in one stage
constexpr milliseconds kStoreRetry{200};  // while the store is away
constexpr std::size_t kLongestMessage = 500;
constexpr int kNoGarment = 4, kStartFailed = 127;  // exit statuses

// What `main` writes before a failure.
std::string without_name(std::string line) {
  constexpr std::string_view kName = "regarment: ";
  if (line.starts_with(kName)) line.erase(0, kName.size());
  return line;
}

/// One attempt, from the start of its child to its end.
class Attempt {
 public:
  Attempt(const Claim& claim, JobStore& store, JobFiles& files, const WorkerOptions& options,
          const std::function<bool()>& wanted)
      : claim_(claim),
        job_(claim_.job),
        token_(claim_.token),
        store_(store),
        files_(files),
        folders_(files.folders()),
        options_(options),
        wanted_(wanted),
        progress_(claim.job.kind) {}

  ~Attempt() { files_.forget(claim_); }
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  void run() {
    try {
      files_.fetch(claim_, store_, goes_on_);
      const auto command = job_command(job_, folders_, store_, options_.program, options_.threads);
      ChildProcess child(command,
                         {options_.time, options_.memory_mb << 20U, options_.file_mb << 20U});
      watch(child);
    } catch (const Stopped&) {
      leave();
    } catch (const ClaimLost&) {
      clear_away();
    } catch (const NoAccess&) {
      until_told([&] { store_.hand_back(job_.id, token_); });
      throw;
    } catch (const TemporaryError& error) {
      conclude({AttemptEnd::Kind::TryAgain, {"temporary", error.what()}});
    } catch (const ReadError& error) {
      conclude({AttemptEnd::Kind::Failed, {"unreadable_scan", error.what()}});
    } catch (const Error& error) {
      conclude({AttemptEnd::Kind::Failed, {"bad_request", error.what()}});
    }
  }

 private:
  void watch(ChildProcess& child) {
    ChildEnd end;
    for (;;) {
      wait_for_children({&child}, kLook);
      child.look_after();
      const bool over = child.ended(end);
      listen(child);
      if (over) return conclude(delivered(end_of(end)));
      if (!goes_on()) return stop(child);
    }
  }

  // The end, once the result of a success is where clients find it.
  AttemptEnd delivered(AttemptEnd end) {
    if (end.kind == AttemptEnd::Kind::Succeeded) bytes_ = files_.deliver(claim_, goes_on_);
    return end;
  }

  // Its last line that is no progress is what it has to say should it fail.
  void listen(ChildProcess& child) {
    for (const std::string& line : child.take_lines()) {
      if (const auto said = parse_progress(line)) {
        tell(*said);
      } else {
        last_words_ = without_name(one_line(line, kLongestMessage));
      }
    }
  }

  AttemptEnd end_of(ChildEnd end) const {
    end.last_line = last_words_;
    // An evaluation some of whose scans came to nothing says so on its page.
    std::error_code ignored;
    const bool told = job_.kind == JobKind::Evaluate && end.status == kNoGarment &&
                      std::filesystem::exists(folders_.result(job_.id, token_), ignored);
    return told ? AttemptEnd{} : attempt_end(end, options_);
  }

  void tell(const ProgressLine& line) {
    const double fraction = progress_.after(line);
    const auto now = Clock::now();
    if (line.stage == stage_ && now < told_ + kTellEvery) return;
    stage_ = line.stage, told_ = now;
    try {
      answer_ = store_.progress(job_.id, token_, fraction, line.stage,
                                one_line(line.detail, kLongestMessage));
    } catch (const TemporaryError&) {
      // The next note says more than this one would have.
    }
  }

  void beat() {
    const auto now = Clock::now();
    if (now < beaten_ + options_.lease / 4) return;
    beaten_ = now;
    try {
      const LeaseAnswer answer = store_.heartbeat(job_.id, token_, options_.lease);
      if (answer_ == LeaseAnswer::Go) answer_ = answer;
      store_.worker_alive(job_.worker, options_.host);
    } catch (const TemporaryError&) {
      beaten_ = now - options_.lease / 4 + kStoreRetry;
    }
  }

  // Whether the job is still ours to do; the store hears of us meanwhile.
  bool goes_on() {
    if (time_to_go())
      answer_ = LeaseAnswer::Lost;
    else
      beat();
    return answer_ == LeaseAnswer::Go;
  }

  // Whether what a worker asked to stop may still take is over.
  bool time_to_go() {
    if (!leave_at_ && !wanted_()) leave_at_ = Clock::now() + options_.grace;
    going_ = leave_at_ && Clock::now() >= *leave_at_;
    return going_;
  }

  void stop(ChildProcess& child) {
    child.signal(SIGTERM);
    const auto patience = Clock::now() + milliseconds(1000);
    ChildEnd end;
    while (Clock::now() < patience && !child.ended(end)) {
      wait_for_children({&child}, kLook);
      child.look_after();
    }
    child.signal(SIGKILL);
    leave();
  }

  void leave() {
    if (going_) {
      until_told([&] { store_.hand_back(job_.id, token_); });
    } else if (answer_ == LeaseAnswer::Cancel) {
      until_told([&] { store_.cancelled(job_.id, token_); });
    }
    clear_away();
  }

  void conclude(const AttemptEnd& end) {
    bool ours = false;
    const milliseconds pause = options_.pause * (1 << std::min(job_.attempts - 1, 10));
    until_told([&] {
      switch (end.kind) {
        case AttemptEnd::Kind::Succeeded:
          ours = store_.succeed(job_.id, token_, bytes_);
          break;
        case AttemptEnd::Kind::Failed:
          store_.fail(job_.id, token_, end.error);
          break;
        case AttemptEnd::Kind::TryAgain:
          store_.try_again(job_.id, token_, end.error, pause, options_.max_attempts);
          break;
      }
    });
    if (!ours && is_useless()) clear_away();
  }

  // Whether the store says that the result counts for nothing: it may have taken it although its
  // answer was lost on the way.
  bool is_useless() const {
    bool useless = false;
    until_told([&] {
      const auto job = store_.find(job_.id);
      useless = !job || job->state != JobState::Succeeded || job->token != token_;
    });
    return useless;
  }

  // Of this attempt alone: another may be under way by now. What is half written goes with the next
  // attempt or the job.
  void clear_away() const {
    std::error_code ignored;
    std::filesystem::remove_all(folders_.result(job_.id, token_), ignored);
  }

  void until_told(const std::function<void()>& tell) const {
    const auto patience = Clock::now() + std::max(options_.lease, options_.grace);
    for (;;) {
      try {
        return tell();
      } catch (const TemporaryError&) {
        if (Clock::now() >= patience) return;
        std::this_thread::sleep_for(kStoreRetry);
      }
    }
  }

  const Claim claim_;
  const Job& job_;
  const std::int64_t token_;
  JobStore& store_;
  JobFiles& files_;
  const JobFolders& folders_;
  const JobFiles::KeepGoing goes_on_ = [this] { return goes_on(); };
  const WorkerOptions& options_;
  const std::function<bool()>& wanted_;
  JobProgress progress_;
  LeaseAnswer answer_ = LeaseAnswer::Go;
  bool going_ = false;
  std::optional<Clock::time_point> leave_at_;
  Clock::time_point beaten_ = Clock::now(), told_{};
  std::string stage_, last_words_;
  std::uint64_t bytes_ = 0;  // of a success: what its files take
};

}  // namespace

AttemptEnd attempt_end(const ChildEnd& end, const WorkerOptions& options) {
  using Kind = AttemptEnd::Kind;
  const auto say = [&](const std::string& otherwise) {
    return end.last_line.empty() ? otherwise : end.last_line;
  };
  if (end.timed_out) {
    return {Kind::TryAgain,
            {"timed_out", "took longer than " + std::to_string(options.time.count() / 1000) +
                              " s; use a scan with fewer vertices, or allow more (fit_seconds)"}};
  }
  if (end.signal == SIGKILL) {
    return {Kind::TryAgain,
            {"out_of_memory",
             "was killed, most likely for want of memory; use a scan with fewer "
             "vertices, or give the machine more"}};
  }
  if (end.signal != 0) {
    const char* name = ::sigabbrev_np(end.signal);
    return {Kind::TryAgain,
            {"crashed", std::string("crashed (SIG") + (name ? name : "?") +
                            "); please report it with the scan"}};
  }
  switch (end.status) {
    case 0:
      return {Kind::Succeeded, {}};
    case 2:
      return {Kind::Failed, {"bad_request", say("the options contradict each other")}};
    case 3:
      return {Kind::Failed, {"unreadable_scan", say("the scan cannot be read")}};
    case kNoGarment:
      return {Kind::Failed, {"no_garment", say("the garment was not found")}};
    case 75: {
      const bool memory = end.last_line.starts_with("out of memory");
      return {Kind::TryAgain, {memory ? "out_of_memory" : "temporary", say("a temporary failure")}};
    }
    case kStartFailed:
      return {Kind::TryAgain, {"temporary", "the program could not be started"}};
    case 128 + SIGINT:
    case 128 + SIGTERM:
      return {Kind::TryAgain, {"crashed", say("was stopped by a signal")}};
    default:
      return {Kind::Failed, {"internal", say("ended with status " + std::to_string(end.status))}};
  }
}

void run_attempt(const Claim& claim, JobStore& store, JobFiles& files, const WorkerOptions& options,
                 const std::function<bool()>& wanted) {
  Attempt(claim, store, files, options, wanted).run();
}

}  // namespace regarment
