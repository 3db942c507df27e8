#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace regarment {

/// Declares the options of `fit` that every fit of many is to be given: --method, --seed, --runs,
/// --evaluations and --args. They become words for `fit`, which checks their values.
void add_every_fit_options(CLI::App& command, std::vector<std::string>& words);

/// What `fit` would say to this command (program, "fit", ...), before any is run. Throws
/// UsageError, also when it is a fit of other garments than these.
void check_fit_command(const std::vector<std::string>& command,
                       const std::vector<std::string>& garments);

}  // namespace regarment
