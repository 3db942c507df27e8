#include "synthetic/synthesize.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/error.h"
#include "base/stopwatch.h"

namespace regarment {
namespace {

constexpr std::chrono::milliseconds kTellEvery{100};

void check_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw InvalidInput("synthesize: " + std::string(name) + " is " +
                     std::to_string(std::llround(value)) + ", it must be " +
                     std::to_string(std::llround(low)) + " to " +
                     std::to_string(std::llround(high)));
}

// The cases shared out to threads, and what they have made of them.
class Workshop {
 public:
  using Take = std::function<void(const std::vector<CaseFile>&)>;

  Workshop(const SynthesizeOptions& options, const Take& take) : options_(options), take_(take) {
    truth_.resize(static_cast<std::size_t>(options.cases));
  }

  void work() {
    const Progress progress([this](std::string_view, double) { return !stopped(); });
    for (int i = next(); i >= 0; i = next()) {
      try {
        MadeCase made = make_case(options_.seed, options_.first + static_cast<std::uint32_t>(i),
                                  options_.wish, options_.dress, progress);
        put(i, std::move(made));
      } catch (...) {
        fail(std::current_exception());
      }
    }
  }

  // Waits until all is made, telling progress; a stop or an error ends the work early.
  void watch(const Progress& progress) {
    Stopwatch watch;
    double seconds = 0;
    std::unique_lock lock(mutex_);
    while (done_ < options_.cases && !stop_) {
      changed_.wait_for(lock, kTellEvery);
      seconds += watch.lap();
      const int done = done_;
      lock.unlock();
      try {
        progress.report("synthesize", static_cast<double>(done) / options_.cases,
                        told(done, seconds));
      } catch (...) {
        fail(std::current_exception());
      }
      lock.lock();
    }
  }

  std::vector<CaseTruth> result() {
    if (error_) std::rethrow_exception(error_);
    return std::move(truth_);
  }

 private:
  int next() {
    const std::lock_guard lock(mutex_);
    return stop_ || next_ >= options_.cases ? -1 : next_++;
  }

  bool stopped() {
    const std::lock_guard lock(mutex_);
    return stop_;
  }

  void put(int i, MadeCase made) {
    const std::lock_guard lock(mutex_);
    if (stop_) return;
    take_(made.files);
    truth_[static_cast<std::size_t>(i)] = std::move(made.truth);
    ++done_;
    changed_.notify_all();
  }

  // The first error counts; what the others say follows from it.
  void fail(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
    stop_ = true;
    changed_.notify_all();
  }

  std::string told(int done, double seconds) const {
    std::string out = std::to_string(done) + " of " + std::to_string(options_.cases) + " cases";
    if (done == 0 || done == options_.cases) return out;
    const auto left = std::lround(seconds / done * (options_.cases - done));
    return out + ", " +
           (left < 90 ? std::to_string(left) + " s" : std::to_string(left / 60) + " min") + " left";
  }

  const SynthesizeOptions& options_;
  const Take& take_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<CaseTruth> truth_;
  std::exception_ptr error_;
  int next_ = 0, done_ = 0;
  bool stop_ = false;
};

}  // namespace

void SynthesizeOptions::check() const {
  check_range("cases", cases, 1, 100000);
  check_range("threads", threads, 1, 256);
  check_range("first", first, 0, 10000000);
  dress.check();
}

Synthesis synthesize(const SynthesizeOptions& options,
                     const std::function<void(const std::vector<CaseFile>&)>& take,
                     const Progress& progress) {
  options.check();
  Workshop workshop(options, take);
  const int count = std::min(options.threads, options.cases);
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    threads.emplace_back([&] { workshop.work(); });
  }
  workshop.watch(progress);
  for (std::thread& thread : threads) thread.join();
  return {workshop.result()};
}

std::vector<CaseFile> truth_tables(const Synthesis& synthesis) {
  std::string json = "[";
  std::string csv(truth_csv_header());
  for (const CaseTruth& truth : synthesis.truth) {
    json += (json.size() > 1 ? ",\n" : "\n") + truth_json(truth);
    csv += truth_csv_rows(truth);
  }
  return {{"truth/truth.json", json + "\n]\n"}, {"truth/ground_truth.csv", csv}};
}

}  // namespace regarment
