#pragma once

#include <optional>
#include <string>
#include <vector>

namespace regarment {

struct ToolRun {
  int status = 0;
  std::string text;  // standard output and standard error together
};

/// Runs another program, arguments as they are, and waits for it. Nothing when there is no such
/// program.
std::optional<ToolRun> run_tool(const std::vector<std::string>& arguments);

/// A file beside this one.
std::string beside_tests(const std::string& name);

}  // namespace regarment
