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
};

/// How a sandboxed child ended.
struct SandboxEnd {
  enum class Kind { Finished, CpuLimit, TimeLimit, Killed, Signal, NotStarted };
  Kind kind = Kind::Finished;
  std::string detail;  // of Signal: its name; of NotStarted: what failed
};

/// Runs `work` in a child process that can compute and write to SharedMemory, and nothing else: no
/// file, no socket, no process (seccomp allow-list, resource limits, all descriptors closed). Its
/// exceptions must not leave it. Meanwhile `meanwhile` runs here; then this waits, asking
/// `progress` ten times a second. The child is gone when this returns or throws, also when
/// `progress` throws Stopped, and it dies with this process. A child that lasts ten times its CPU
/// seconds by the clock is ended too.
///
/// Call it before threads that could hold a lock in the middle of a fork are started: the child
/// allocates memory (which glibc makes safe after a fork) but also uses what `work` uses.
/// Under the address and thread sanitizers, which need files and much address space themselves,
/// neither the filter nor the memory limit is set, and CPU seconds count tenfold.
SandboxEnd run_sandboxed(const std::function<void()>& work, const SandboxLimits& limits,
                         const Progress& progress, const std::function<void()>& meanwhile);

}  // namespace regarment
