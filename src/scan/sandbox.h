#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "base/progress.h"

namespace regarment {

/// Memory that a child made by `run_sandboxed` shares with us. Pages nobody touches cost nothing.
class SharedMemory {
 public:
  /// Zeroed. Throws TemporaryError when the address space does not suffice.
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  std::span<std::byte> span() const { return {data_, size_}; }

 private:
  std::byte* data_;
  std::size_t size_;
};

struct SandboxLimits {
  std::uint64_t memory = 256U << 20U;  // bytes on top of what the caller has mapped
  unsigned cpu_seconds = 3;
  unsigned clock_seconds = 60;  // for a child that waits instead of computing
};

/// How a sandboxed child ended.
struct SandboxEnd {
  enum class Kind { Finished, CpuLimit, TimeLimit, Killed, Signal, NotStarted };
  Kind kind = Kind::Finished;
  std::string detail;  // of Signal: its name; of NotStarted: what failed
};

/// Runs `work` in a child process that can compute and write to SharedMemory, and nothing else: no
/// file, no socket, no process (seccomp allow-list, resource limits, all descriptors closed). No
/// exception may leave `work`. Meanwhile `meanwhile` runs here; then this waits, asking `progress`
/// ten times a second. The child is gone when this returns or throws, also when `progress` throws
/// Stopped, and it dies with the calling thread; signals to the whole process group pass it by.
///
/// Several threads may call it. But a fork copies the locks that other threads hold just then:
/// glibc makes allocation safe in the child, other libraries do not, so call it before threads are
/// started where that can be helped. A child stuck on such a lock ends as TimeLimit.
SandboxEnd run_sandboxed(const std::function<void()>& work, const SandboxLimits& limits,
                         const Progress& progress, const std::function<void()>& meanwhile);

/// False in builds with the address or thread sanitizer, which need files and address space of
/// their own: there neither the filter nor the memory limit is set, and CPU seconds count tenfold.
bool sandbox_is_closed();

}  // namespace regarment
