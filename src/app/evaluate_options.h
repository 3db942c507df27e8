#pragma once

#include "app/command_line.h"

namespace CLI {
class App;
}

namespace regarment {

/// Declares the options of `evaluate`.
void add_evaluate_options(CLI::App& evaluate, EvaluateArguments& a);

/// Throws UsageError when options contradict each other.
void check_evaluate_options(const EvaluateArguments& a);

}  // namespace regarment
