#pragma once

#include <string>

namespace CLI {
class App;
}

namespace regarment {

/// Adds the command `completion SHELL`, which sets `shell`, and the command `manual`.
CLI::App* add_completion(CLI::App& app, std::string& shell);
CLI::App* add_manual(CLI::App& app);

/// A script by which a shell completes commands, options and their values: "bash", "zsh" or "fish".
/// Throws UsageError for another shell.
std::string completion_script(const CLI::App& app, const std::string& shell);

/// The manual page regarment(1), roff with the man macros: every command with its options.
std::string manual_page(const CLI::App& app, const std::string& version);

}  // namespace regarment
