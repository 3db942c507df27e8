#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace regarment {

/// From now on each call of the functions below uses at most so many threads (>= 1). At first as
/// many as the machine has processors.
void limit_threads(int most);

/// Calls `work(begin, end)` on parts of 0..count, on as many threads as there may be. The parts
/// have `grain` items each, whatever the number of threads, so work that writes only to its own
/// items gives the same result everywhere. `work` runs on several threads at once. An exception of
/// any part is thrown again in the caller, after all threads have ended.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& work);

/// Calls each of the tasks once, as many at once as there may be threads; they must not write what
/// another one reads. Otherwise as parallel_for.
void run_together(const std::vector<std::function<void()>>& tasks);

}  // namespace regarment
