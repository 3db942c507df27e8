#include "batch/run_scans.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "evaluation/child_pool.h"
#include "evaluation/scan_outcome.h"
#include "report/files.h"
#include "report/result.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using State = ScanStatus::State;

constexpr std::size_t kMostResultBytes = 64U << 20U;
// Exit statuses.
constexpr int kInternal = 1, kUnreadable = 3, kTemporary = 75, kNotStarted = 127;

bool may_be_tried_again(const ChildEnd& end) {
  return !end.timed_out &&
         (end.status == kTemporary || end.status == kNotStarted || end.status > 128);
}

// Of a scan whose tries all ended together with what ran them.
ScanFailure ended_from_outside() {
  return {"crash", kTemporary,
          "whatever fitted it was ended from outside " + std::to_string(kMostAttempts) +
              " times; see whether there is memory enough, then use --retry"};
}

class Runner {
 public:
  Runner(const BatchFolder& folder, const Manifest& manifest, const RunScansOptions& options,
         const RunScansTold& told)
      : folder_(folder), manifest_(manifest), options_(options), told_(told) {}

  // What is left is tried again after the others, in the order of attempts.
  void run(std::vector<std::size_t> left) {
    park_the_poisonous(left);
    while (!left.empty()) {
      std::stable_sort(left.begin(), left.end(),
                       [&](auto a, auto b) { return attempts(a) < attempts(b); });
      try_each(left);
      std::erase_if(left, [&](std::size_t i) { return ended_.contains(i); });
    }
  }

 private:
  const BatchScan& scan(std::size_t i) const { return manifest_.scans[i]; }
  int attempts(std::size_t i) const { return folder_.attempts(scan(i).name); }

  void park_the_poisonous(std::vector<std::size_t>& left) {
    for (const std::size_t i : left) {
      if (attempts(i) >= kMostAttempts) conclude(i, State::Parked, ended_from_outside());
    }
    std::erase_if(left, [&](std::size_t i) { return ended_.contains(i); });
  }

  void try_each(const std::vector<std::size_t>& left) {
    std::vector<std::vector<std::string>> commands;
    commands.reserve(left.size());
    for (const std::size_t i : left) commands.push_back(command(i));
    ChildPoolOptions pool{options_.at_once, std::chrono::seconds(manifest_.timeout)};
    pool.starting = [&](std::size_t k) {
      folder_.begin_attempt(scan(left[k]).name);
      at_work_.insert(left[k]);
    };
    const auto ended = [&](std::size_t k, const ChildEnd& end) {
      at_work_.erase(left[k]);
      take(left[k], end);
    };
    try {
      run_children(commands, pool, ended, told_.still_wanted);
    } catch (...) {
      for (const std::size_t i : at_work_) folder_.give_back_attempt(scan(i).name);
      throw;
    }
  }

  std::vector<std::string> command(std::size_t i) const {
    std::vector<std::string> out = {options_.program.string(), "fit"};
    out.insert(out.end(), scan(i).words.begin(), scan(i).words.end());
    out.insert(out.end(), {"--out", folder_.fit(scan(i).name).string(), "--force"});
    return out;
  }

  void take(std::size_t i, const ChildEnd& end) {
    if (end.status == 0) return take_result(i);
    ScanFailure failure = *failed_scan({}, end, manifest_.timeout).failure;
    if (!may_be_tried_again(end)) return conclude(i, State::Failed, failure);
    if (attempts(i) < kMostAttempts) return;
    failure.line = "tried " + std::to_string(kMostAttempts) + " times: " + failure.line;
    conclude(i, State::Parked, failure);
  }

  // The bytes that were fitted must be those that were planned.
  void take_result(std::size_t i) {
    try {
      const auto text = read_file(folder_.fit(scan(i).name) / "result.json", kMostResultBytes);
      if (parse_result(text, "result.json").scan.sha256 == scan(i).sha256) {
        return conclude(i, State::Succeeded, std::nullopt);
      }
      const std::string why = "the file is not the one the batch was planned with; run it again";
      conclude(i, State::Failed, ScanFailure{"changed", kUnreadable, why});
    } catch (const ReadError& error) {
      conclude(i, State::Failed, ScanFailure{"internal error", kInternal, error.what()});
    }
  }

  void conclude(std::size_t i, State state, std::optional<ScanFailure> failure) {
    ScanStatus status{state, scan(i).name, scan(i).key, "", std::move(failure)};
    if (state == State::Succeeded) {
      status.result_sha256 = folder_.result_sha256(scan(i).name);
    } else {
      std::error_code ignored;
      fs::remove_all(folder_.fit(scan(i).name), ignored);  // of other options or bytes
    }
    folder_.write_status(status);
    ended_.insert(i);
    told_.done(i, status);
  }

  const BatchFolder& folder_;
  const Manifest& manifest_;
  const RunScansOptions& options_;
  const RunScansTold& told_;
  std::set<std::size_t> at_work_, ended_;
};

}  // namespace

void run_scans(const BatchFolder& folder, const Manifest& manifest,
               const std::vector<std::size_t>& scans, const RunScansOptions& options,
               const RunScansTold& told) {
  Runner(folder, manifest, options, told).run(scans);
}

}  // namespace regarment
