#include "geometry/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace regarment {
namespace {

constexpr unsigned kMostThreads = 16;  // of one call

std::atomic<unsigned> threads_allowed = std::max(1U, std::thread::hardware_concurrency());

}  // namespace

void limit_threads(int most) { threads_allowed = static_cast<unsigned>(std::max(1, most)); }

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& work) {
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t parts = (count + grain - 1) / grain;
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto run = [&] {
    try {
      for (std::size_t part = next++; part < parts; part = next++) {
        work(part * grain, std::min(count, (part + 1) * grain));
      }
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = parts;
    }
  };
  const std::size_t wanted = std::min<std::size_t>({threads_allowed, parts, kMostThreads});
  std::vector<std::jthread> helpers;
  try {
    for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(run);
  } catch (const std::system_error&) {
    // No more threads to be had: the ones there are do the work.
  }
  run();
  helpers.clear();
  if (failure) std::rethrow_exception(failure);
}

void run_together(const std::vector<std::function<void()>>& tasks) {
  parallel_for(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) tasks[i]();
  });
}

}  // namespace regarment
