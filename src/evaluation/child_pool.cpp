#include "evaluation/child_pool.h"

#include <signal.h>

#include <algorithm>
#include <memory>

namespace regarment {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLook{100};
constexpr std::chrono::milliseconds kShortest{1};
constexpr std::chrono::milliseconds kGrace{1000};  // between SIGTERM and SIGKILL

/// A child and the place of its command.
struct Child {
  std::size_t index;
  ChildProcess process;
};

using Children = std::vector<std::unique_ptr<Child>>;

void wait_a_little(const Children& children) {
  std::vector<const ChildProcess*> processes;
  processes.reserve(children.size());
  for (const auto& child : children) processes.push_back(&child->process);
  wait_for_children(processes, kLook);
}

// All at once and politely, so that each can remove what is half written.
void stop(Children& children) {
  for (const auto& child : children) child->process.signal(SIGTERM);
  const auto patience = Clock::now() + kGrace;
  while (!children.empty() && Clock::now() < patience) {
    wait_a_little(children);
    std::erase_if(children, [](const auto& child) {
      ChildEnd ignored;
      child->process.look_after();
      return child->process.ended(ignored);
    });
  }
}

// Starts, tends and reaps until all commands have ended.
void run(const std::vector<std::vector<std::string>>& commands, const ChildPoolOptions& options,
         const std::function<void(std::size_t, const ChildEnd&)>& ended,
         const std::function<void()>& still_wanted, Children& children) {
  // A limit of nothing would be none at all.
  const ChildLimits limits{std::max<std::chrono::milliseconds>(options.timeout, kShortest), 0, 0};
  std::size_t next = 0;
  while (next < commands.size() || !children.empty()) {
    still_wanted();
    while (next < commands.size() && children.size() < static_cast<std::size_t>(options.at_once)) {
      if (options.starting) options.starting(next);
      children.push_back(
          std::unique_ptr<Child>(new Child{next, ChildProcess(commands[next], limits)}));
      ++next;
    }
    wait_a_little(children);
    for (std::size_t i = 0; i < children.size();) {
      ChildEnd end;
      children[i]->process.look_after();
      if (!children[i]->process.ended(end)) {
        ++i;
        continue;
      }
      const std::size_t index = children[i]->index;
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(i));
      ended(index, end);
    }
  }
}

}  // namespace

void run_children(const std::vector<std::vector<std::string>>& commands,
                  const ChildPoolOptions& options,
                  const std::function<void(std::size_t, const ChildEnd&)>& ended,
                  const std::function<void()>& still_wanted) {
  Children children;
  try {
    run(commands, options, ended, still_wanted, children);
  } catch (...) {
    stop(children);
    throw;
  }
}

}  // namespace regarment
