#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "base/child_process.h"

namespace regarment {

struct ChildPoolOptions {
  int at_once = 1;                                      // >= 1
  std::chrono::seconds timeout{3600};                   // of each child
  std::function<void(std::size_t command)> starting{};  // told before each is started; may be empty
};

/// Runs the commands (absolute path of a program, then its arguments), `at_once` at a time and in
/// their order, and tells `ended` of each in the order they end. Standard input and output of a
/// child are /dev/null. A child whose time is over, and every child when a callback
/// throws, is stopped together with all processes it began: SIGTERM, and SIGKILL a
/// second later. Children end with this program however it ends. `still_wanted` is called several
/// times a second from the calling thread. Throws TemporaryError when no process can be started.
void run_children(const std::vector<std::vector<std::string>>& commands,
                  const ChildPoolOptions& options,
                  const std::function<void(std::size_t command, const ChildEnd&)>& ended,
                  const std::function<void()>& still_wanted);

}  // namespace regarment
